mrcal-no_dictionary = This is not a .cameramodel file; it has no dictionary.
    .do = Check that it is the right file.
