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
    .do = Run raybundle studio { $folder } on the command line, and correct the error shown.

# $number = 4
# $n = 3
studio-no_figure = There is no figure { $number }; there are { $n }, counted from 0.
    .do = { $n ->
            [0] Adjust the block first
            *[other] Give a number below { $n }
        }.

studio-no_adjustment = There is no adjustment yet.
    .do = Adjust first, or wait until the adjustment in progress has finished.

studio-no_photographs = No folder or file of photographs is given.
    .do = Give the folder of the photographs in the first field.

studio-nothing_to_run = Stages cannot run in this folder; its block can be adjusted.
    .do = Open a project folder of orient, a result folder of calibrate, or a folder of photographs.

studio-busy = A run or an adjustment is in progress.
    .do = Stop it, or wait until it has finished.

# $port = 8000
# $detail = "Address already in use"
studio-port_in_use = Port { $port } cannot be used ({ $detail }).
    .do = Omit { OPTION("port") }; a free port is then used.

# $number = 2
# $stored = [3, 4]
# $n = 2
studio-adjustment_not_stored = Adjustment { $number } is not stored; { $n ->
        [0] no adjustment is stored
       *[other] stored: { LIST($stored, most: 20) }
    }.
    .do = { $n ->
            [0] Adjust the block first
            *[other] Choose one of the stored adjustments
        }.

# $number = 2
# $name = "report.html"
studio-adjustment_without_page = Adjustment { $number } has no { $name }.
    .do = Adjust again; this writes the page.

studio-photograph_file_unknown = The file of this photograph is not known.
    .do = Start the studio with the folder of the photographs: { OPTION("photos") }.

# $level = 7
# $n = 5
studio-no_level = There is no level { $level }; there are { $n }, counted from 0.
    .do = Give a level below { $n }.

# $across = 12
# $down = 3
# $level = 1
studio-tile_outside = Tile { $across }, { $down } of level { $level } is outside the photograph.
    .do = Reload the page; in a program, give a tile inside the photograph.
