"""What a user of an extension repository does: add its address, install, and later update.

    run.py's Blender --python repository_user.py -- ADDRESS FOLDER UPDATE

ADDRESS: of the index of FOLDER. After installing, the index and package of the folder UPDATE take
their places in FOLDER. Prints the versions that were installed; test_repository.py reads them.
"""

import os
import pathlib
import shutil
import sys
import tomllib
import traceback

import bpy

NAME = "illustrate"


def add_repository(address: str) -> int:
    """Adds the repository; its place in the list. A file's address counts as online too."""
    bpy.context.preferences.system.use_online_access = True
    bpy.ops.preferences.extension_repo_add(
        name="Drawings", remote_url=address, use_sync_on_startup=False, type="REMOTE"
    )
    repositories = bpy.context.preferences.extensions.repos
    return next(i for i, one in enumerate(repositories) if one.remote_url == address)


def installed_version(place: int) -> str:
    """By the manifest that Blender unpacked."""
    folder = pathlib.Path(bpy.context.preferences.extensions.repos[place].directory)
    text = (folder / NAME / "blender_manifest.toml").read_text(encoding="utf-8")
    return str(tomllib.loads(text)["version"])


def main() -> None:
    """Installs, enables and updates."""
    address, folder, update = sys.argv[-3:]
    place = add_repository(address)
    bpy.ops.extensions.repo_sync(repo_index=place)
    bpy.ops.extensions.package_install(repo_index=place, pkg_id=NAME, enable_on_install=True)
    print("installed:", installed_version(place))
    print("registered:", hasattr(bpy.types, "ILLUSTRATE_OT_illustrate"))
    shutil.copytree(update, folder, dirs_exist_ok=True)
    bpy.ops.extensions.repo_sync(repo_index=place)
    bpy.ops.extensions.package_upgrade_all(use_active_only=False)
    print("updated:", installed_version(place))
    print("still registered:", hasattr(bpy.types, "ILLUSTRATE_OT_illustrate"))


if __name__ == "__main__":
    code = 0
    try:
        main()
    except Exception:
        traceback.print_exc()
        code = 1
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)
