block-no_oriented_image = Le bloc { $block } n'a aucune image orientée.

block-nothing_to_write = Le bloc { $block } n'a ni points ni photographies ; rien à écrire.

block-is_a_file = C'est un fichier, pas le dossier d'un bloc.

block-result_folder = C'est le dossier d'un résultat, pas d'un bloc.

block-no_block_toml = Le dossier n'a pas de block.toml ; ce n'est pas un bloc.

block-file_missing = Le fichier manque ; un bloc en a besoin.

block-file_name = Le fichier n'est pas lu sous ce nom.

block-observations_not_parquet = La table est lue d'un coup ; un bloc plus grand que la mémoire demande Parquet.

block-no_camera = Le bloc n'a pas de caméra.

block-no_scene = Le bloc { $block } n'a pas de scène satellite ; les RPC ne sont écrits que pour des scènes.

block-not_numbers = Bloc { $block } : { $name } contient { $type } ; il faut des nombres.

block-not_whole_numbers = Bloc { $block } : { $name } contient { $type } ; les positions sont des entiers.

block-position_out_of_range = Bloc { $block } : { $name }[{ $row }] vaut { $position } ; les positions vont de 0 à { $last }.

block-shape = Bloc { $block } : { $name } doit être un tableau de forme ({ $shape }).

block-number_too_large = { $kind ->
        [image] Image { $image }
        [point] Point { $point }
       *[observation] Image { $image }, point { $point }
     } : { $number } n'est pas un nombre jusqu'à { $limit }.

block-single_image = L'image { $image } seule ne détermine pas les points objet { $points }.

block-parts_without_datum = Le bloc a { $parts } parties sans points de liaison communs ; { $n } sans référence.

block-open_part = Non déterminé pour les images { LIST($images, most: 10) } : { datum-part }.

block-scale_free = L'échelle du bloc n'est pas déterminée : aucune longueur ne la fixe.

block-not_adjusted = Le bloc n'est pas compensé : des images sans orientation, ou des points sans coordonnées.

block-heights_defined = Le bloc { $block } définit déjà la référence de ses altitudes.

block-place_defined = Le bloc { $block } définit déjà la place de son repère sur la terre.

block-origin_missing = Le bloc { $block } a des longueurs en { $unit } ; ses coordonnées ne sont pas celles de { $system }.

block-folder_needs_observations = Le bloc { $block } n'a pas d'observations image ; un dossier de bloc en a besoin.
