board-view_too_few_points = La vue { $view } de la mire montre { $n } points ; il en faut { $least }.

board-no_lens = Aucun modèle d'objectif ne convient aux vues de la mire : il reste { $residual_px } px.

board-charuco_name = { $name } n'est pas le nom d'une mire ChArUco.

board-charuco_size = { $name } n'est pas possible comme mire ChArUco.

board-charuco_tags = { $name } demande { $n } marqueurs ; { $tags } en a { $most }.

board-chessboard_name = { $name } n'est pas le nom d'un échiquier.

board-chessboard_size = { $name } : il faut au moins 3 x 3 coins intérieurs.

board-dots_name = { $name } n'est pas le nom d'une grille de disques.

board-dots_size = { $name } : il faut au moins 3 x 3 disques.

board-not_alone = Un panneau ({ $board }) ne peut pas être combiné avec d'autres cibles dans un étalonnage.
