# SPDX-License-Identifier: MIT
"""The .soffit file of a sample, written so that a reader can follow it line by line."""
import json


class Project:
    def __init__(self, name, obj, exposure=0.0, white_balance=None):
        self.name, self.obj, self.exposure = name, obj, exposure
        self.white_balance = white_balance  # kelvin
        self.materials, self.luminaires, self.layouts = {}, [], []
        self.cameras, self.work_planes = [], []

    def material(self, name, diffuse, **more):
        """diffuse: linear Rec.709 reflectance, one number for grey or three."""
        colour = [diffuse] * 3 if isinstance(diffuse, (int, float)) else list(diffuse)
        self.materials[name] = {"diffuse": colour, **more}

    def luminaire(self, name, **fields):
        self.luminaires.append({"name": name, **luminaire_fields(**fields)})

    def layout(self, name, **edits):
        """edits: {luminaire name: fields}, under the keyword `luminaires`."""
        self.layouts.append({"name": name, **edits})

    def camera(self, name, position, target, vertical_fov):
        self.cameras.append({"name": name, "position": position, "target": target,
                             "vertical_fov": vertical_fov})

    def work_plane(self, name, origin, u, v, grid, room_type):
        self.work_planes.append({"name": name, "origin": origin, "u": u, "v": v, "grid": grid,
                                 "room_type": room_type})

    def view(self):
        view = {"exposure": self.exposure, "ocio_display": "sRGB", "ocio_view": "Filmic",
                "ocio_look": ""}
        if self.white_balance is not None:
            view["white_balance"] = self.white_balance
        return view

    def content(self):
        return {
            "soffit": 1,
            "name": self.name,
            "geometry": [{"file": self.obj, "unit": 1.0, "up": "z"}],
            "materials": self.materials,
            "luminaires": self.luminaires,
            "layouts": self.layouts,
            "cameras": self.cameras,
            "work_planes": self.work_planes,
            "view": self.view(),
            "quality": "interactive",
        }

    def write(self, path):
        path.write_text(_lines(self.content()), encoding="utf-8")


def luminaire_fields(shape, position, flux, group, rotation=(0, 0, 0), cct=None, rgb=None,
                     distribution="lambertian", **more):
    colour = {"rgb": list(rgb)} if rgb is not None else {"cct": cct}
    return {"shape": shape, "position": [round(c, 4) for c in position], "rotation": list(rotation),
            "flux": flux, "colour": colour, "distribution": distribution, "casts_shadow": False,
            "dimming": 1.0, "on": True, "group": group, **more}


def _lines(content):
    """One line for each entry of a list or table at the second level, and of a layout's edits."""
    def row(value):
        return json.dumps(value, ensure_ascii=False)

    def table(mapping, indent):
        inner = ",\n".join(f"{indent}  {row(k)}: {row(v)}" for k, v in mapping.items())
        return "{\n" + inner + "\n" + indent + "}"

    def layout(value):
        if "luminaires" not in value:
            return row(value)
        return (f'{{ "name": {row(value["name"])}, "luminaires": '
                + table(value["luminaires"], "      ") + " }")

    blocks = []
    for key, value in content.items():
        if isinstance(value, list) and value:
            text = "[\n" + ",\n".join(
                f"    {layout(v) if key == 'layouts' else row(v)}" for v in value) + "\n  ]"
        elif key == "materials":
            text = table(value, "  ")
        else:
            text = row(value)
        blocks.append(f"  {row(key)}: {text}")
    return "{\n" + ",\n".join(blocks) + "\n}\n"
