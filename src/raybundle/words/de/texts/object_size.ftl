object_size-flat = { NUM($width_m, digits: 5) } x { NUM($height_m, digits: 5) } m

object_size-building = { NUM($width_m, digits: 5) } x { NUM($depth_m, digits: 5) } x { NUM($height_m, digits: 5) } m{ $corners ->
        [4] {""}
        *[other] , { $corners } Ecken
    }

object_size-cylinder = { NUM($diameter_m, digits: 5) } m Durchmesser, { NUM($height_m, digits: 5) } m hoch

object_size-corridor = { NUM($length_m, digits: 5) } m lang, { NUM($width_m, digits: 5) } m breit

object_size-heights = { NUM($width_m, digits: 5) } x { NUM($length_m, digits: 5) } m, Zellen von { NUM($cell_m) } m

object_size-points = aus { $n } Punkten, { NUM($width_m) } x { NUM($length_m) } m

object_size-mesh = { NUM($x_m, digits: 4) } x { NUM($y_m, digits: 4) } x { NUM($z_m, digits: 4) } m, { $n } Dreiecke

object_size-free_scale = { $size }, in beliebigem Maßstab
