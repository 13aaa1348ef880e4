# $page = "'report'"
studio-page_of_folder = what = { $page } needs an adjustment, not a folder.
    .do = Use what="studio", or open report.html of the folder.

studio-path_of_folder = A path is given, but the result is in a folder already.
    .do = Leave path out.

# $folder = "facade"
# $status = 1
# $n = 16
# $detail = "address in use"
studio-not_started = The studio of { $folder } ended with status { $status }{ $n ->
        [0] { " " }and no output
       *[other] : { $detail }
     }
