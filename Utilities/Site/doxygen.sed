# What every class of VTK has needs no words of its own, and what subclasses alone see is not for users.
/^  static .* New();$/i\  /// Makes one.
/^  void PrintSelf(/i\  /// Prints its state.
/^protected:$/,/^};$/{/^};$/!d}
