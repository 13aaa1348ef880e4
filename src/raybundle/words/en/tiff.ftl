# $byte = 120000
tiff-ends_early = The TIFF file ends before byte { $byte }.
    .do = Copy it again.

tiff-no_tiff = The file is not a TIFF file.
    .do = Give a TIFF file, or convert the picture to TIFF.

# $n = 60000
# $most = 4096
tiff-too_many_tags = The TIFF directory has { $n } tags; at most { $most } are read.
    .do = Check that the file is not damaged.

# $bits = [32]
# $format = [3]
tiff-pixel_format = The pixels have { $bits } bits, sample format { $format }; whole numbers of 8 or 16 bits are supported.
    .do = Convert the file, for example with gdal_translate -ot UInt16.

tiff-directory_damaged = The TIFF directory lacks sizes or positions of the pixels.
    .do = Copy the file again.

# $n = 10
# $needed = 24
tiff-too_few_tiles = The TIFF file has { $n } strips or tiles; { $needed } are needed.
    .do = Copy it again.

tiff-pixels_end_early = The pixels of the TIFF file end too early.
    .do = Copy it again.

# $compression = 34712
# $bands = 3
# $bits = 8
tiff-pixels_unreadable = The pixels cannot be decoded (compression { $compression }, bands { $bands }, bits { $bits }).
    .do = Convert the file, for example with gdal_translate -co COMPRESS=NONE.

# $compression = 34887
tiff-compression = The pixels are compressed by method { $compression }, which needs the extra [geo].
    .do = Install it (pip install 'raybundle[geo]'), or write the file by gdal_translate -co COMPRESS=DEFLATE.
