// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

/// Small models as text: a block of 4 x 5 x 2.8, standing on the origin's corner unless stated.
namespace soffit::io {

inline constexpr std::string_view kBlockObj = R"(o block
v 0 0 0
v 4 0 0
v 4 5 0
v 0 5 0
v 0 0 2.8
v 4 0 2.8
v 4 5 2.8
v 0 5 2.8
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
)";

inline constexpr std::string_view kBlockPly = R"(ply
format ascii 1.0
element vertex 8
property float x
property float y
property float z
element face 6
property list uchar int vertex_index
end_header
0 0 0
4 0 0
4 5 0
0 5 0
0 0 2.8
4 0 2.8
4 5 2.8
0 5 2.8
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
)";

inline constexpr std::string_view kTriangleStl = R"(solid wedge
facet normal 0 0 1
outer loop
vertex 0 0 2.8
vertex 4 0 2.8
vertex 4 5 2.8
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 4 0 0
vertex 0 5 0
endloop
endfacet
endsolid wedge
)";

/// In millimetres, centered on the z axis; a brick of color (0.8, 0.4, 0.2).
inline constexpr std::string_view kBlockIfc = R"(ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('ViewDefinition [CoordinationView]'),'2;1');
FILE_NAME('block.ifc','2024-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('IFC2X3'));
ENDSEC;
DATA;
#1=IFCPERSON($,'a',$,$,$,$,$,$);
#2=IFCORGANIZATION($,'a',$,$,$);
#3=IFCPERSONANDORGANIZATION(#1,#2,$);
#4=IFCAPPLICATION(#2,'1','a','a');
#5=IFCOWNERHISTORY(#3,#4,$,.NOCHANGE.,$,$,$,0);
#6=IFCCARTESIANPOINT((0.,0.,0.));
#7=IFCAXIS2PLACEMENT3D(#6,$,$);
#8=IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#7,$);
#9=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);
#10=IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.);
#11=IFCUNITASSIGNMENT((#9,#10));
#12=IFCPROJECT('0YvctVUKr0kugbFTf53O9L',#5,'p',$,$,$,$,(#8),#11);
#13=IFCLOCALPLACEMENT($,#7);
#14=IFCSITE('1YvctVUKr0kugbFTf53O9L',#5,'Site',$,$,#13,$,$,.ELEMENT.,$,$,0.,$,$);
#15=IFCRELAGGREGATES('2YvctVUKr0kugbFTf53O9L',#5,$,$,#12,(#14));
#20=IFCCARTESIANPOINT((0.,0.));
#21=IFCAXIS2PLACEMENT2D(#20,$);
#22=IFCRECTANGLEPROFILEDEF(.AREA.,$,#21,4000.,5000.);
#23=IFCDIRECTION((0.,0.,1.));
#24=IFCEXTRUDEDAREASOLID(#22,#7,#23,2800.);
#25=IFCSHAPEREPRESENTATION(#8,'Body','SweptSolid',(#24));
#26=IFCPRODUCTDEFINITIONSHAPE($,$,(#25));
#27=IFCBUILDINGELEMENTPROXY('3YvctVUKr0kugbFTf53O9L',#5,'Block','','',#13,#26,$,$);
#28=IFCRELCONTAINEDINSPATIALSTRUCTURE('4YvctVUKr0kugbFTf53O9L',#5,$,$,(#27),#14);
#30=IFCCOLOURRGB($,0.8,0.4,0.2);
#31=IFCSURFACESTYLERENDERING(#30,0.,$,$,$,$,$,$,.FLAT.);
#32=IFCSURFACESTYLE('Brick',.BOTH.,(#31));
#33=IFCPRESENTATIONSTYLEASSIGNMENT((#32));
#34=IFCSTYLEDITEM(#24,(#33),$);
ENDSEC;
END-ISO-10303-21;
)";

/// One glTF triangle (0,0,0) (1,0,0) (0,1,0), y up, in a node with the given JSON members (e.g. a
/// transform) and with the given list of materials and further top-level members.
inline std::string triangleGltf(const std::string& node, const std::string& materials,
                                const std::string& more = "") {
  // 36 bytes of positions.
  const std::string buffer = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
         R"("nodes":[{"name":"panel","mesh":0)" +
         (node.empty() ? "" : "," + node) +
         R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0})" +
         std::string(materials.empty() ? "" : R"(,"material":0)") + R"(}]}],)" +
         (materials.empty() ? "" : R"("materials":[)" + materials + "],") + more +
         R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)" + buffer +
         R"("}],"bufferViews":[{"buffer":0,"byteLength":36,"byteOffset":0}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",)"
         R"("min":[0,0,0],"max":[1,1,0]}]})";
}

}  // namespace soffit::io
