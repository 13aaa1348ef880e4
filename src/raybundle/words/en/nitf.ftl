nitf-no_image = The NITF file contains no image.
    .do = Check that it is the right file.

nitf-no_rpc = The first image of the NITF file has no RPC00B.
    .do = Give the file with the RPC (.XML, .RPB).

# $name = "RPC00B"
# $success = "'0'"
nitf-rpc_invalid = { $name } is incomplete or invalid (SUCCESS { $success }).
    .do = Get the file again, or give one with the RPC (.XML, .RPB).

# $name = "NROWS"
# $value = "'abc'"
# $n = 8
nitf-field = NITF field { $name } is { $value }, not { $n } digits.
    .do = Get the file again; it is damaged.
