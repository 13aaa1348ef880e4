orientation_fix-count = Nombre de points d'orientation : { $n }.

orientation_fix-time_order = Le temps du point d'orientation { $later } ne suit pas celui du point { $earlier }.

orientation_fix-outside_image = Tous les points d'orientation sont avant la première ligne de l'image ou après la dernière.
