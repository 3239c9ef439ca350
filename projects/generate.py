#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the sample projects beside this file (standard library only, the same bytes every time).

    projects/generate.py                 all samples
    projects/generate.py office flat     some of them
    projects/generate.py --check         checks what is there: see generator/check.py
"""
import argparse
import importlib
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
SAMPLES = ["cornell", "flat", "gallery", "office"]


def make(name):
    return importlib.import_module(f"generator.{name}").make()


def write(name, sample, folder):
    folder.mkdir(exist_ok=True)
    sample["model"].write(folder / f"{name}.obj", sample["title"], sample["project"].materials, f"{name}.mtl")
    sample["project"].write(folder / f"{name}.soffit")
    for file, content in sample.get("files", {}).items():
        if isinstance(content, bytes):
            (folder / file).write_bytes(content)
        else:
            content.write(folder / file, "Luminous mesh", {"light": {"diffuse": [0.8, 0.8, 0.8]}},
                          Path(file).with_suffix(".mtl").name)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("samples", nargs="*", default=SAMPLES, metavar="SAMPLE", help=", ".join(SAMPLES))
    parser.add_argument("--check", action="store_true", help="check the samples instead of writing them")
    arguments = parser.parse_args()
    unknown = [name for name in arguments.samples if name not in SAMPLES]
    if unknown:
        parser.error(f"no sample is called {unknown[0]}; there are {', '.join(SAMPLES)}")
    if not arguments.check:
        for name in arguments.samples:
            sample = make(name)
            write(name, sample, HERE / name)
            print(f"{name}: {sample['model'].triangle_count()} triangles, "
                  f"{sum(f.stat().st_size for f in (HERE / name).iterdir()) / 1e6:.2f} MB")
        return 0
    from generator import check
    faults = [fault for name in arguments.samples for fault in check.check(name, make(name), HERE)]
    print("\n".join(faults) or "all samples are sound")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
