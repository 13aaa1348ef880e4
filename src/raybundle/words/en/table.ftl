table-more_errors = There are more errors; the rest of the file was not read.
