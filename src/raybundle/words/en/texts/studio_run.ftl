studio_run-title = Run of all stages

# $name = "orient"
studio_run-begin = Run { $name }
    .title = Run all stages in the background; stored ones are not repeated

studio_run-stop = Stop
    .title = Stop between two tasks; finished ones are stored

studio_run-begun = Running the stages.

studio_run-progress = Progress of this step

studio_run-stages = Stages

studio_run-stage = stage

studio_run-state = state

studio_run-output = Output of the command

studio_run-settings = Settings

studio_run-settings_note = Settings of the last run in this folder; changed ones are highlighted.
    .why = Marks stay, and are used with the next Adjust.

studio_run-settings_stored = Settings of the next run stored.

studio_run-photos_help = Folders and files of the photographs. Put names with blanks in quotation marks.

# $outcome = "done"
# $time = "12 s"
studio_run-ended = { $outcome ->
        [done] Done
        [stopped] Stopped
        *[failed] Failed
    } after { $time }

studio_run-stopped = Stopped; finished stages are stored, and another run continues there.

# $step = "matching"
studio_run-stopping = Stopping after the current task: { $step }

# $step = "matching"
# $percent = 40
# $rest = "12 s"
# $time = "2 min"
studio_run-going = { $step }: { $percent } %{ $rest ->
        [none] {""}
        *[other] , { $rest } left
    }; { $time } in total

# $status = 3
studio_run-status = The command ended with status { $status }.

# $detail = "result.json is missing"
studio_run-unreadable = The new result cannot be read: { $detail }

# $state = "done"
studio_run-stage_state = { $state ->
        [at_work] in progress
        [done] done
        [kept] from an earlier run
        [not_needed] not needed
        *[waiting] waiting
    }

# $stage = "matching"
# $name = "matching"
studio_run-stage_name = { $stage ->
        [photographs] photographs
        [features] features
        [matching] matching
        [start] approximate orientation
        [precision] least-squares matching
        [least_squares_matching] least-squares matching
        [adjustment] adjustment
        [adjusting] adjustment
        [report] report
        [targets] targets
        [verdict] verdict
        [orienting] orientation
        [orienting_all_images_at_once] orientation of all images
        [statistics] statistics
        [covariances] covariances
        [control] control
        [what_was_photographed] detection of targets
        [cross_validation] cross-validation
        [reading_photographs] reading photographs
        [writing] writing
        [tracks] tie points
        [cleaning] removal of blunders
        [weights] weights
        [writing_tables] writing tables
        [beginning] begin
        *[other] { $name }
    }
