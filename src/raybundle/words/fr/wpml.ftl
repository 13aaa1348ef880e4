wpml-action_end = Un groupe d'actions finit au point { $way_point } ; il y en a { $n }.
