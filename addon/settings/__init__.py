"""What an artist can set: of scenes, collections, objects, materials and lights."""
