#pragma once
#include <string>

#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace cleave::app {

/// While it lives, VTK's errors and warnings are collected here; they are never printed, nor are
/// later ones.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  bool any() const;
  /// What VTK said first (the rest follows from it), without its source place and address.
  std::string first() const;

 private:
  class Window;
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkSmartPointer<Window> window_;
};

}  // namespace cleave::app
