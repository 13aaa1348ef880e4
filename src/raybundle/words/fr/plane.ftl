plane-points_in_line = Plan { $name } : ses points sont alignés.

plane-axes_not_orthogonal = right, up et normal ne forment pas un repère orthonormé (écart { $deviation }, limite { $limit }).

plane-place_unknown = La position du plan est inconnue : right, up et normal manquent.

plane-other_unit = L'unité du plan est { $plane }, celle du bloc { $block }.
