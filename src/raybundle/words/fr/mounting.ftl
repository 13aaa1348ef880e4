mounting-no_attitudes = Aucune image n'a à la fois une orientation compensée et une attitude.

mounting-no_positions = Aucune image n'a à la fois une orientation compensée et une position.

mounting-lever_arm = { $n } images ont une orientation et une position ; un bras de levier en demande deux.
