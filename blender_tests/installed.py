"""The add-on that is tested: a zip, installed as a user would, or the folder of a build."""

import importlib
import os
import pathlib
import pkgutil
import sys
import time
from typing import Any

import bpy

HERE = pathlib.Path(__file__).resolve().parent
NAME = "illustrate"


def provide() -> None:
    """Makes `import illustrate` find the add-on.

    $ILLUSTRATE_ZIP names a package to install and enable; else it is the add-on of
    $ILLUSTRATE_ADDONS, a folder of add-ons, or of build/addons.
    """
    archive = os.environ.get("ILLUSTRATE_ZIP")
    if not archive:
        folder = HERE.parent / "build" / "addons"
        sys.path.insert(0, os.environ.get("ILLUSTRATE_ADDONS", str(folder)))
        return
    package = install(os.path.abspath(archive))
    bpy.ops.wm.save_userpref()
    _rename(package)


def install(archive: str) -> str:
    """Installs and enables a package; the name of the module. Says how long enabling takes."""
    if bpy.app.version >= (4, 2, 0):
        package = f"bl_ext.user_default.{NAME}"
        bpy.ops.extensions.package_install_files(
            filepath=archive, repo="user_default", enable_on_install=False, overwrite=True
        )
    else:
        package = NAME
        bpy.ops.preferences.addon_install(filepath=archive, overwrite=True)
    start = time.perf_counter()
    bpy.ops.preferences.addon_enable(module=package)
    module = importlib.import_module(f"{package}.native").load()
    print(f"enabled in {time.perf_counter() - start:.3f} s: {module.__file__}", flush=True)
    return package


def _rename(package: str) -> None:
    """The same modules under the name that they have in a build."""
    module = sys.modules[package]
    for found in pkgutil.walk_packages(module.__path__, f"{package}."):
        if ".illustrate_native" not in found.name:
            importlib.import_module(found.name)
    for name in [name for name in sys.modules if name.startswith(package)]:
        sys.modules[NAME + name[len(package) :]] = sys.modules[name]


def is_enabled(package: Any) -> bool:
    """True for an installed add-on that the preferences have."""
    return package.__name__ in bpy.context.preferences.addons
