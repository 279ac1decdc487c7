"""Meshes cut to the outline of what the alpha of their materials' images shows."""
