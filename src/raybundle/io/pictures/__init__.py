"""Pictures made of photographs: without distortion, or of a plane to scale."""
