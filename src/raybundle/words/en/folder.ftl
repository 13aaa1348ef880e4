folder-exists = The folder already exists and is not empty.
    .do = Choose another folder, or delete it.

# $scheme = "https:"
folder-url = The path begins like a URL ({ $scheme }//).
    .why = Results are written to folders of this computer.
    .do = Write to a folder, and copy it there. { OPTION("store", "URL") } keeps products of orient and surface in a bucket.

# $parent = "results.csv"
folder-parent_is_a_file = { $parent } is not a folder; nothing can be written in it.
    .do = Choose another path.

folder-special_file = This is neither a file nor a folder.
    .do = Choose another name.

folder-is_a_file = A file with this name exists; a folder is needed.
    .do = Choose another name.

# $name = "image.dat"
folder-file_missing = The folder has no file { $name }.
    .do = Check that it is the right folder.

# $n = 2
# $name = "NAME.im"
folder-several_files = The folder has { $n } files { $name }; one is needed.
    .do = Move the others elsewhere.

# $detail = "Permission denied"
folder-not_listed = The folder cannot be listed ({ $detail }).
    .do = Check the permissions.

folder-missing = The folder of this file does not exist.
    .do = Create it first.

folder-other_block = The folder contains another block, which is not overwritten.
    .do = Choose another { OPTION("out") }.

folder-missing_itself = There is no such folder.
    .do = Check the path.
