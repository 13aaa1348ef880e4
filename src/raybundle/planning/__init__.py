"""What a network will determine before it is photographed: networks, simulation, predictions, the next photographs."""
