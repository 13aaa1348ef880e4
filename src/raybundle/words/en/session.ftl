session-no_project = This is not a project, result or block folder: block.toml is missing.
    .why = It is searched here, in block and in result/block.
    .do = Give the folder that { OPTION("out") } named.
