# $detail = "Permission denied"
file-not_readable = The file cannot be read ({ $detail }).
    .do = Check the path and the permissions.

file-missing = There is no such file or folder.
    .do = Check the path.

file-memory = The file requires more memory than is available.
    .do = Check that the file is complete and of the right format.

file-not_computable = The numbers of this file lead to no result.
    .why = The file is probably damaged.
    .do = Export it again.

# $target = "../photos"
file-link_broken = This link points to { $target }, which does not exist.
    .do = Correct or delete the link.

file-link_loop = A link in this path points back to itself.
    .do = Delete the link, or choose another path.

file-impossible_name = This name is not possible for a file.
    .do = Check the path.

# $kind = "folder"
file-not_a_file = This is a { $kind ->
        [folder] folder
        [pipe] pipe
        [socket] socket
       *[device] device
     }, not a file.
    .do = Give the name of a file.

# $size_bytes = 2000000000
# $limit_bytes = 1073741824
file-too_large = The file has { $size_bytes } bytes; at most { $limit_bytes } are read.
    .do = Check that it is the right file.

file-changed = The file changed while it was read.
    .do = Wait until it is complete, then try again.

# $byte = "0x1b"
file-control_character = The file contains control character { $byte }; it is not a text file.
    .do = Check that the file is not damaged.

# $byte = "0xff"
# $utf16 = false
file-not_utf8 = Byte { $byte } is not UTF-8{ $utf16 ->
        [yes] { " " }(the file seems to be UTF-16)
       *[no] { "" }
     }.
    .do = Save the file with the encoding UTF-8.

# $most = 100
file-nested_too_deeply = Values are nested more than { $most } levels deep.
    .do = Check that it is the right file.

file-number_too_long = A number has too many digits to be read.
    .do = Check that the file is not damaged.

# $detail = "invalid syntax"
file-not_understood = The content cannot be interpreted ({ $detail }).
    .do = Check that the file is complete.

file-exists = The file already exists.
    .do = Choose another name, or allow overwriting: --overwrite, in Python raybundle.overwriting().

file-is_a_folder = This is a folder.
    .do = Give the name of a file.

# $detail = "Permission denied"
# $refused = true
file-not_writable = Nothing can be written here ({ $detail }).
    .do = { $refused ->
        [yes] Choose a folder with write permission
       *[no] Free disk space, or choose another folder
     }.

file-created_meanwhile = Another run created this name in the meantime; the result of this run is discarded.
    .do = Choose another name and run it again.

file-no_images = There are no images in it.
    .do = Check that it is the right file.

file-empty = The file is empty.
    .do = Check that it is complete.

# $known = [".html", ".htm"]
file-suffix = The name must end in { LIST($known, most: 20) }.
    .do = Choose such a name.

file-name_not_utf8 = This name is not valid UTF-8.
    .why = The result contains its name in UTF-8.
    .do = Choose another { OPTION("out") }.

file-read_by_command = This file is input of the command; it is not overwritten.
    .do = Choose another name.

# $detail = "truncated file"
file-hdf5_damaged = The HDF5 file is damaged or incomplete ({ $detail }).
    .do = Get the file again.
