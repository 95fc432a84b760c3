# New and PrintSelf of every VTK class get standard texts, and protected members are removed.
/^  static .* New();$/i\  /// Creates an instance.
/^  void PrintSelf(/i\  /// Prints its state.
/^protected:$/,/^};$/{/^};$/!d}
# The methods of properties (vtkHorizonProperty.h): Doxygen gives a comment to what follows it alone.
/^  vtkHorizonChoice[2-5]Macro(/{
:line
/;$/!{
N
b line
}
s/\n */ /
s/^  vtkHorizonChoice.Macro(\(\w*\), \(\w*\), \(.*\));/  virtual void Set\1(int value);\n  \/\/\/ See Set\1().\n  virtual int Get\1();\n  \/\/\/ Values of \1.\n  enum \2 { \3 };\n@\1@\3@/
:value
s/@\(\w*\)@\(\w\w*\)\(, \)\?\(.*\)@$/  \/\/\/ See Set\1().\n  void Set\1To\2();\n@\1@\4@/
t value
s/\n@\w*@@$//
}
s/^  vtkHorizonNumberMacro(\(\w*\), \(.*\));/  virtual void Set\1(\2 value);\n  \/\/\/ See Set\1().\n  virtual \2 Get\1();/
s/^  vtkHorizonTextMacro(\(\w*\));/  virtual void Set\1(const char* value);\n  \/\/\/ See Set\1().\n  virtual const char* Get\1();/
s/^  vtkHorizonFlagMacro(\(\w*\));/  virtual void Set\1(bool value);\n  \/\/\/ See Set\1().\n  virtual bool Get\1();\n  \/\/\/ See Set\1().\n  virtual void \1On();\n  \/\/\/ See Set\1().\n  virtual void \1Off();/
s/^  vtkHorizonVectorMacro(\(\w*\), \(\w*\), 2);/  virtual void Set\1(\2 first, \2 second);\n  \/\/\/ See Set\1().\n  virtual \2* Get\1();/
s/^  vtkHorizonVectorMacro(\(\w*\), \(\w*\), \(.\));/  virtual void Set\1(const \2 values[\3]);\n  \/\/\/ See Set\1().\n  virtual \2* Get\1();/
