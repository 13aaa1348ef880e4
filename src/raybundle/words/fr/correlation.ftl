correlation-contained = Les écarts-types des points contiennent cette corrélation.
