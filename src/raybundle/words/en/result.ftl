result-not_a_folder = A file with this name exists; the result is a folder.
    .do = Choose another name for the result.

result-other_folder = This folder is not a result and is not overwritten.
    .do = Choose another name.

# $names = ["notes.txt"]
# $n = 1
result-foreign_files = The folder contains { $n } { $n ->
     [one] file
     *[other] files
    } not written by an adjustment: { LIST($names, most: 3) }.
    .do = Move them elsewhere, or choose another name.

result-no_result = This is not a result folder: result.json is missing.
    .do = Give the folder written by the adjustment ({ OPTION("out") }).

result-not_of_adjustment = The file is not the result.json of an adjustment.
    .do = Adjust again.

# $id = "'P1'"
# $table = "block/points.csv"
result-unknown_id = { $id } is not in { $table }; the result is damaged.
    .do = Adjust again.

result-no_folder = There is no such folder.
    .do = Give a result or a project of orient.

result-none_in_folder = The folder has no result.json, block.toml or project.db.
    .do = Give a result, a block folder or a project of orient.
