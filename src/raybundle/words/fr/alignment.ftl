alignment-too_few_points = { $kind } { $name } : { $n } points distincts ; il en faut { $least }.
