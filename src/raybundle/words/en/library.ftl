library-not_determinable = The photographs did not determine this camera; it is not added to the library.
    .why = It would spoil every block that uses it.
    .do = Take the photographs that the report names, and calibrate again.

library-no_key = The library finds a calibration by camera model and EXIF focal length; one is missing.
    .do = Give a photograph of the set ({ OPTION("photo", "FILE") }), or { OPTION("camera_model", "NAME") } and { OPTION("focal", "MM") }.
