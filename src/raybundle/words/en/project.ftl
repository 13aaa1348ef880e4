project-folder_not_empty = The folder exists and is neither empty nor a project.
    .do = Choose another { OPTION("out") }.

# $detail = "database disk image is malformed"
# $damaged = true
project-not_readable = The project database cannot be read ({ $detail }).
    .why = { $damaged ->
        [yes] Features are not lost; pairs are matched again.
       *[no] Another program may use the project.
     }
    .do = { $damaged ->
        [yes] Delete this file and run the same command again
       *[no] Close other programs that use the project, or choose another { OPTION("out") }
     }.

# $found = "2"
# $read = 3
project-schema = The project was written by another version (schema { $found }; this version reads { $read }).
    .do = Orient into a new folder.

project-no_database = This is not a project folder: project.db is missing.
    .do = Start a project with raybundle orient.

project-in_use = Another run is active in this project.
    .do = Wait for it, or choose another { OPTION("out") }.

# $table = "orient"
project-table_not_writable = Table [{ $table }] cannot be written without changing another one.
    .do = Write it by hand, with plain headers and texts of one line.

project-no_run = This is not a project folder, or no run was started in it.
    .do = Run the command that starts the tasks first.

# $cause = "full"
# $detail = "No space left on device"
# $kept = true
project-not_writable = The folder cannot be written ({ $detail }).
    .why = { $kept ->
        [yes] Finished products remain; the run continues there.
       *[no] No product is finished yet.
     }
    .do = { $cause ->
        [full] Free disk space and run the same command again
        [occupied] Move the file or folder of this name elsewhere, and run the same command again
       *[other] Choose a folder with write permission
     }.

# $n = 2
# $names = ["img_01.jpg", "img_02.jpg"]
project-photographs_missing = { $n } { $n ->
        [one] photograph
       *[other] photographs
     } of the project { $n ->
        [one] is
       *[other] are
     } missing: { LIST($names, most: 3) }.
    .do = Add the missing photographs, or choose another project.

project-not_a_project = This is not a project folder.
    .do = Give the folder of a project, or a new name; orient then uses the record in the new project.

# $n = 1
# $near = ["facade"]
project-missing = There is no such project.
    .do = { $n ->
        [0] Begin
       *[other] Check whether { LIST($near, most: 1) } is meant, or begin
     } one by an entry such as { OPTION("object", "NAME") }, with { OPTION("new", "True") }.

project-no_result = The project has no current result.
    .do = Orient its photographs, again if a result was deleted: finished stages are taken from the project.

project-at_url = A project cannot be at a URL; its folder must be on this machine.
    .do = Give a folder, and the URL for the products: { OPTION("store", "URL") }.

project-base_missing = The result without marks, into which the marks are merged, is missing or damaged.
    .do = Run `raybundle orient` again: it makes it anew, and adjusts with the marks.

# $n = 2
project-result_damaged = The current result of the project is damaged.
    .do = Delete this folder and run `raybundle orient` again.{ $n ->
        [0] {""}
       *[other] {" Earlier ones are in the folder results."}
    }
