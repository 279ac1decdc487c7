"""What Blender has, as arrays for the core."""
