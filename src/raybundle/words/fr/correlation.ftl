correlation-contained = Les écarts-types des points contiennent cette corrélation.

correlation = Caméra { $name } : { $first } et { $second } sont corrélés à { NUM($correlation, decimals: 2) }.
