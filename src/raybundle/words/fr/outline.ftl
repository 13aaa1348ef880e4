outline-crosses_itself = { $name } se croise aux côtés partant des sommets { $first } et { $second }.

outline-no_area = { $name } n'enferme aucune surface.
