# $byte = 120000
tiff-ends_early = The TIFF file ends before byte { $byte }.
    .do = Copy it again.

tiff-no_tiff = This is not a TIFF file.

# $n = 60000
# $most = 4096
tiff-too_many_tags = The TIFF directory has { $n } tags; at most { $most } are read.
    .do = Check that the file is not damaged.
