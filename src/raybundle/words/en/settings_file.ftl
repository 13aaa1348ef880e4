# $flag = "--settings"
settings_file-flag_only = { $flag } is possible on the command line only, not in a file.
    .do = Delete the entry.

# $name = "ajust"
# $table = true
# $n = 1
# $near = ["[adjust]"]
# $general = "[every]"
settings_file-unknown_table = { $table ->
        [yes] [{ $name }] is not the table of a command
       *[no] { $name } is in no table of a command, nor in { $general }
     }.
    .do = { $n ->
        [0] Name the table after a command, such as [adjust]
       *[other] Check whether { $near } is meant
     }.

# $entry = "[adjust] rejct"
# $flag = "--rejct"
# $command = "raybundle adjust"
# $every = false
# $n = 1
# $near = ["reject"]
settings_file-unknown_option = { $entry }: { $every ->
        [yes] no command has
       *[no] { $command } does not have
     } the option { $flag }.
    .do = { $n ->
        [0] Delete the entry
       *[other] Check whether { $near } is meant
     }.
