positions_exchanged = Les positions de { $first } et { $second } semblent interverties ; aucune n'est utilisée.
