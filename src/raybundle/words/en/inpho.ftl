inpho-not_closed = The last record PHOTO is not closed by END: the file is incomplete.
    .do = Copy the file again.
