"""As in a new scene: even lines, hatches in two tones."""

import bpy

bpy.context.scene.illustrate.restore_defaults()
