comparison-path_taken = A file that is not a comparison already has this name.
    .do = Choose another name, or delete the file.
