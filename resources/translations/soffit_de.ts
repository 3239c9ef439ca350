<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Application</name>
    <message>
        <source>Interactive, converged light for indoor architecture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Project or model to open</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DragSession</name>
    <message>
        <source>Copy to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Copy %n luminaires</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n luminaires</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Resize %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Resize %n luminaires</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Move %n luminaires</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>soffit::ui</name>
    <message>
        <source>The project was not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soffit projects (*.soffit);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import a model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Models (*.obj *.gltf *.glb *.ply *.stl *.3ds *.fbx *.dae *.ifc);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the project as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soffit projects (*.soffit)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without saving they are lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The readings were not written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>General</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⌀ 0.9 m, suspended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0.6 × 0.6 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panel long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1.2 × 0.3 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1.5 m, on the ceiling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear suspended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1.5 m, suspended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pendant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⌀ 0.4 m, suspended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Downlight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>70°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>24°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Track spot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>36°, on a track</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall washer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lights one side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⌀ 0.3 m, suspended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Custom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>see Properties</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dim %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch on %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch off %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light scene %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scene %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store light scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename light scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete light scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click goes back or forward to that step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Properties</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light mixer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Materials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lambertian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isotropic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RGB</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::Aiming</name>
    <message>
        <source>Aim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the point to aim at. Shift: aim again. Esc: done.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::ArrayBar</name>
    <message>
        <source>Line along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luminaires along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luminaires along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spacing along x; 0: the walls half a spacing away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spacing along y; 0: the walls half a spacing away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to the walls %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::Arraying</name>
    <message numerus="yes">
        <source>Array of %n luminaires</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Drag squares for the spacing, disks for the count. Enter: apply. Esc: give up.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of a command</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::ComparisonBar</name>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap: edit the other layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap the layouts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout to compare with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A slider between the two</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two pictures, one camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One after the other (B)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Illuminance of the second minus that of the first, in lux</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends of the scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the comparison (Shift+B)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::ComparisonSession</name>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::ComparisonView</name>
    <message>
        <source>Split between the layouts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 − %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::DifferenceModel</name>
    <message>
        <source>Ēm lx</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emin lx</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U₀</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emax lx</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Φ lm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lm/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P W</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Work plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::DrawingPolygon</name>
    <message>
        <source>first corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>General</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline crosses itself: take corners back with Backspace.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the corners of the luminaire on the ceiling. Ctrl: grid. Esc: give up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next corner; Enter or the first corner closes the outline. Backspace: take one back.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::GroupStrip</name>
    <message>
        <source>On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only this group, to look at it; others go dark until then</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select its luminaires</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimming</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimming of the group; where its luminaires differ, of the brightest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlated colour temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coloured light…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coloured light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Some</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mixed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::ImportSheet</name>
    <message>
        <source>A new project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The open project, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What one unit of the file is; files that state their unit are in metres already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Into</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the model…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unusual for a building: is the unit right?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The new project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soffit projects (*.soffit)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::KeysDialog</name>
    <message>
        <source>&amp;Assign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mouse and dragging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 › %2 has these keys and will lose them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command or key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys as in another program, for the commands that Soffit has, too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset a&amp;ll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select; drag a luminaire or the gizmo; elsewhere orbit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift or Ctrl + click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add to the selection, remove from it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift or Ctrl + drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from an empty place: select by a rubber band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift + drag a luminaire</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drag a copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a luminaire: its properties; a surface: its material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle, or Shift + right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move toward what is under the cursor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While dragging: X, Y, Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lock an axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While dragging: digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>type a value, such as 1.2 or 120 cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While dragging: Ctrl</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whole steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While dragging: Alt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>do not snap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter, Esc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end a drag; give it up, or select nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 to 9, Ctrl + 1 to 9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recall a light scene, store one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>next layout</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::LayoutsPanel</name>
    <message>
        <source>Layouts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A copy of this layout to change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete this layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare the layout shown with another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What all layouts have in common</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F2: rename; drag: another place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::Legend</name>
    <message>
        <source>Scale of illuminance</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::LibraryPanel</name>
    <message>
        <source>Search: name, lumens, angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kinds of luminaires</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click, then click in the view; or drag it there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a folder of IES and LDT files…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n files could not be read</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Folder of photometric files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::LightsModel</name>
    <message>
        <source>Luminaire</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flux</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change flux</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change colour temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::LightsPanel</name>
    <message>
        <source>Filter by name, group, colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luminaires</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click or F2 to edit all that are selected: 80 %, +=10, *=1.2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::LogPanel</name>
    <message>
        <source>Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::LuminaireDrag</name>
    <message>
        <source>_ ?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::LuminairePanel</name>
    <message>
        <source>Switched on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimming</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the full flux</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luminous flux over the whole luminaire, undimmed: 1200 lm, 1.2 klm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlated colour temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mixed or none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its body casts shadows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flux</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x, y, z of the luminaire&apos;s origin: 3.2 m, 320 cm, 10&apos; 6&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the fixed x, y and z axes, in that order: 40 deg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change flux</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change colour temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let it cast shadows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let it cast no shadows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a luminaire in the view or in the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n luminaires</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mixed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::MainWindow</name>
    <message>
        <source>Select the luminaire that is to be repeated first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not pasted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Snap to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rotate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resi&amp;ze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Ceiling and walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also the middle between two walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other &amp;luminaires</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Their axes, and their spacing carried on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Grid of 0.1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where nothing else attracts; Ctrl while dragging does the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An empty project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Import a model…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Architecture or furniture, into a new project or this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;ample projects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export the view…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A picture of the view at any size, without gizmo and outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export a &amp;set of pictures…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From cameras and of layouts, into a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cop&amp;y the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Q</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Photometric file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Photometry (*.ies *.IES *.ldt *.LDT)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file was not read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Models (*.obj *.OBJ *.ply *.stl *.glb *.gltf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mesh was not read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a &amp;photometric file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a &amp;mesh file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OBJ and other models</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make &amp;luminous</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a part of the building that is to give light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Draw a luminaire</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corner by corner, on the ceiling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L&amp;ayouts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duplicate the layout shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>De&amp;lete the layout shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move do&amp;wn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with a &amp;slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare side &amp;by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bl&amp;ink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This layout and another in turn; again: stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference in lu&amp;x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;End the comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Luminaire</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch &amp;on or off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dim to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Aim at…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the point of a surface that the selection is to light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;rray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide o&amp;thers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Show all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+H</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light scenes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall scene %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store scene %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project was not opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>opening %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soffit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] – Soffit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame &amp;all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame &amp;selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Plan from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+Home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Through the ceiling, to arrange and draw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;False colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Illuminance by colour, with a scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Brighter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Darker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Commands...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run any command by a few letters of its name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the mouse does, and the keys of all commands, to change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Soffit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Soffit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Soffit %1&lt;/b&gt;&lt;p&gt;Interactive, converged light for indoor architecture.&lt;/p&gt;&lt;p&gt;MIT licence. With Qt %2 (LGPL 3), VTK (BSD 3), OpenColorIO, Embree, OpenImageIO and others, as the system provides them.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy the table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As text for a spreadsheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export the table…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The figures of all layouts as comma-separated values</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::MakingLuminous</name>
    <message>
        <source>too large a part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the part of the building that is to give light. Shift: several. Esc: done.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::MaterialsPanel</name>
    <message>
        <source>Materials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reflectance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reflectance ρ: the share of white light that comes back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More than 90 %: white paint reaches 85 to 90 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its colour; the reflectance stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gloss seen straight on: 4 % for paint, wood and plastics, more for metals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 % is a mirror, 100 % the widest gloss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Specular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change reflectance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change gloss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change roughness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>glass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Glass: it reflects nothing until it is computed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its picture %1 is multiplied by the colour.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::MixerPanel</name>
    <message>
        <source>Luminaires with the same group are mixed here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store what is lit now as a scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (key %2). Right-click: rename, store, delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Store what is lit now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::PictureDialog</name>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export a set of pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the view, %1 × %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Twice the view, %1 × %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG, as it is seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JPEG, as it is seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TIFF, as it is seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenEXR, luminance in cd/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Legend of false colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Title: project, layout and camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>soffit::ui::PictureExport</name>
    <message>
        <source>Wrote %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project has no cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save views in the View panel: the set takes a picture from each.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taking pictures</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::Placing</name>
    <message>
        <source>Place %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: click where it goes. Space: turn. Shift: place several. Alt: no snapping. Esc: done.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::ProjectFiles</name>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No project can be made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 cannot be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>importing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model was not imported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::ProjectSession</name>
    <message>
        <source>The picture was not written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing the first light…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The precomputation was cancelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No light was computed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop the model of a building here, or import one: File ▸ Import a model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::QualityPanel</name>
    <message>
        <source>Draft: quick to precompute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interactive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Final: finer, slower to update</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How finely light is precomputed. Another quality is precomputed in the background.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last move of a luminaire</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direct light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In closed form times visibility, at every point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First reflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From every point, by precomputed rays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All further reflections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solved to a residual, not counted in bounces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gathering them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From patches to where light differs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interpolated with precomputed weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light transport</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where light is computed and sent on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gather points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of these, where rays were traced for all the others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not needed here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the project&apos;s own %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coarse, being refined</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>complete</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::QuantityBox</name>
    <message>
        <source>mixed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::RecoveryDialog</name>
    <message>
        <source>Unsaved work was found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soffit did not end as it should. These versions were kept; the project files themselves are as you saved them last.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Versions that were kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
%2
%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::RelightWorker</name>
    <message>
        <source>from the cache</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>computed in %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light transport %1: %2 points, %3 MB</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::ResultsModel</name>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n luminaire(s) whose photometric file declares no power are left out</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Luminaires changed; the reading is under way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Work plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ēm lx</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emin lx</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U₀</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emax lx</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Φ lm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lm/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P W</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The layout in the view is in bold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The grid of points that is read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean illuminance (maintenance factor 1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least illuminance of all points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uniformity: least over mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greatest illuminance of all points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luminous flux of what is on, as it is dimmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luminous flux over the area of all work planes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input power that the photometric files declare, times dimming</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power over the area of all work planes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::ResultsPanel</name>
    <message>
        <source>Readings of the work planes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two layouts compared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Differences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The two layouts that are compared, and what differs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The table as text for a spreadsheet (Ctrl+C): the rows selected, or all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The figures of all layouts, as soffit compare writes them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No readings yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project has no work planes: flux and power alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview: the light transport is still being computed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Work planes of %1 m² in all</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::ShapeFields</name>
    <message>
        <source>along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::ShapeText</name>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rectangle %1 × %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disk ⌀ %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sphere ⌀ %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tube %1, ⌀ %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polygon, %1 corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::SizePreview</name>
    <message>
        <source>%1 wide, %2 deep, %3 high</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::StartPage</name>
    <message>
        <source>Recent projects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Projects that you open appear here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sample projects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a project…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import a building…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A model as glTF, OBJ, IFC, FBX, Collada, 3DS, PLY or STL; it can also be dropped on this window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New project</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::StatusLine</name>
    <message>
        <source>Place under the cursor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Illuminance of the surface under the cursor, and its diffuse luminance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of the light; milliseconds of its last update and of the last picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 s left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · light %2 ms · picture %3 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Converged</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>soffit::ui::ViewPanel</name>
    <message>
        <source>Exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expose for what is seen now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenColorIO view transform, the same in exported pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>False colours of illuminance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save this view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View transform</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
