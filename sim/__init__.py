"""The arm, its kinematics, the scene and the teacher's scripted hand, simulated."""
