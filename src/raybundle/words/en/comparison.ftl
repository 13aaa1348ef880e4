comparison-path_taken = A file that is not a comparison already has this name.
    .do = Choose another name, or delete the file.

comparison-one_result = There is no earlier result to compare with.
    .do = Name two result folders.
