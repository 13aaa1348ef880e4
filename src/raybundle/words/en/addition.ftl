# $camera = "d5100"
addition-camera_not_supported = Camera { $camera }: the effect of a further photograph cannot be predicted.
    .why = The camera is a scene, moves during read-out, or has parameters of its own in each image.
    .do = Choose a frame camera without parameters of single images (per_image).

# $camera = "d5100"
addition-camera_without_photograph = Camera { $camera } has no photograph that takes part.
    .do = Choose a camera with oriented photographs.
