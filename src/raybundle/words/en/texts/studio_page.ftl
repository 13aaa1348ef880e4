studio_page-tabs = Views

studio_page-images = Images

studio_page-space = Space

studio_page-tables = Tables

studio_page-epochs = Dates

studio_page-decide = Decide

studio_page-journal = Journal

studio_page-undo = Undo
    .title = Undo the last action (Ctrl Z)

studio_page-redo = Redo
    .title = Redo the action (Ctrl Shift Z)

studio_page-adjust = Adjust
    .title = Orient and adjust the block with all marks

studio_page-report = Report
    .title = Show the report of an adjustment

studio_page-legend = Legend

studio_page-measuring = Measuring

studio_page-progress = Progress of the adjustment

studio_page-stop = Stop
    .title = Stop the adjustment

studio_page-last_command = Command of the last action

studio_page-connecting = connecting

studio_page-connected = connected

studio_page-connection_lost = Connection lost; trying again

# $status = 500
studio_page-server_status = The server answered with status { $status }.

studio_page-no_answer = The server does not answer.

# $n = 2
studio_page-actions_wait = No answer: { $n } { $n ->
        [one] action waits
        *[other] actions wait
    } and will be sent again.

studio_page-adjusting = Adjusting the block with the marks.

studio_page-busy = An adjustment is in progress already.

# $sigma0 = 0.97
# $folder = "facade/result"
studio_page-adjusted = Adjusted: sigma0 { $sigma0 }{ $folder ->
        [none] .
        *[other] ; result in { $folder }.
    }

# $sigma0 = 0.97
studio_page-sigma0 = sigma0 { $sigma0 }

studio_page-free_scale = scale not defined

# $kind = "project"
# $images = 5
# $points = 1200
studio_page-contents = { $kind ->
        [project] Project
        [result] Result
        *[block] Block
    }: { $images } { $images ->
        [one] image
        *[other] images
    }, { $points } { $points ->
        [one] point
        *[other] points
    }

studio_page-undone = Undone: the last action.

studio_page-redone = Redone.

studio_page-stopped = Stopped; nothing was changed.

studio_page-author = your name

studio_page-copy_all = Copy all
    .title = Copy all commands

studio_page-copy = Copy
    .title = Copy the command of an action

studio_page-copied = Copied.

studio_page-not_copied = The browser does not allow copying.

# $n = 520
# $shown = 500
studio_page-actions = { $n } { $n ->
        [one] action
        *[other] actions
    }, the latest first; { $shown } shown

studio_page-number = no.

studio_page-by = by

studio_page-action = action

studio_page-command = command

# $verb = "put"
studio_page-verb = { $verb ->
        [put] mark
        [move] move mark
        [remove] remove mark
        [point] give point
        [rename] rename point
        [forget] delete point
        [bar] give scale bar
        [unbar] remove scale bar
        [line] line
        [fiducial] fiducial mark
        [datum] coordinate system
        [reject] reject
        [accept] accept
        [reject_beyond] reject by a limit
        [parameter] parameter
        [control] control table
        [mask] mask
        [unmask] remove mask
        [draw] draw
        [erase] erase
        [undo] undo
        [redo] redo
        *[other] { $verb }
    }

# $kind = "ValueError"
# $detail = "no rays"
studio_page-fault = Fault of the program: { $kind }: { $detail }

studio_page-no_page = There is no such page.
    .do = Adjust first; this writes the pages.

studio_page-no_sheet = There is no such sheet; make one first.

# $name = "limit"
# $kind = "number"
studio_page-bad_request = Request: { $name } is no { $kind ->
        [table] table
        [text] text
        [number] number
        [list] list
        [json] JSON
        *[id] identifier
    }.

studio_page-bad_characters = The request holds incomplete characters or numbers that are not finite.

# $most = 8388608
studio_page-too_large = The request is too large (limit { $most } bytes).

# $id = "a1"
studio_page-id_used = Action id { $id } was used before.
    .do = Give each action an id of its own.

studio_page-other_host = This name is not the studio's.
    .do = Open the address that the command printed.

studio_page-other_site = Pages of other sites have no access.

studio_page-no_origin = A connection without its page has no access.

studio_page-not_json = Requests are JSON.

studio_page-no_session = There is no session in this browser.
    .do = Open the address that the command printed; it works once.
