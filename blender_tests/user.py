"""What a new user does with a package, in a Blender of its own: install, use, disable, remove.

    run.py's Blender --python user.py -- PACKAGE [draw]

Prints what happened as lines; test_install.py reads them.
"""

import importlib
import os
import pathlib
import sys
import traceback

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import bpy
import installed

import tools


def classes() -> set[str]:
    return {name for name in dir(bpy.types) if name.startswith("ILLUSTRATE_")}


def draw(package: str) -> None:
    tools.new_file()
    tools.cube_scene(bpy.context.scene)
    print("drew:", *bpy.ops.illustrate.illustrate())
    module = importlib.import_module(f"{package}.native").load()
    print("module:", module.__file__)


def switch_and_remove(archive: str, package: str) -> None:
    """Disable, enable twice, install once more, disable; what is registered at each step."""
    first = classes()
    bpy.ops.preferences.addon_disable(module=package)
    print("left after disabling:", *classes())
    for _ in range(2):
        bpy.ops.preferences.addon_enable(module=package)
    print("same after enabling:", classes() == first)
    installed.install(archive)
    print("same after another install:", classes() == first)
    draw(package)
    if bpy.app.version >= (4, 2, 0):
        repos = [repo.module for repo in bpy.context.preferences.extensions.repos]
        index = repos.index("user_default")
        bpy.ops.extensions.package_uninstall(repo_index=index, pkg_id=installed.NAME)
    else:
        window = bpy.context.window_manager.windows[0]
        with bpy.context.temp_override(window=window, area=window.screen.areas[0]):
            bpy.ops.preferences.addon_remove(module=package)
        assert not (pathlib.Path(bpy.utils.user_resource("SCRIPTS")) / "addons" / package).exists()
    print("left after removing:", *classes())


def main(archive: str) -> None:
    try:
        package = installed.install(archive)
        draw(package)
        switch_and_remove(archive, package)
    except Exception:
        traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0)


if __name__ == "__main__":
    main(sys.argv[-1])
