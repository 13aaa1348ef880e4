surface_points-too_few = { $name } : { $n } points ont des rayons ; une surface en demande { $least }.
