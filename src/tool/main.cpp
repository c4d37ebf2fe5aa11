#include <cstdio>
#include <cstring>
#include <algorithm>
#include <carom/properties/gate.hpp>
#include <carom/subjects/catalogue.hpp>
int main(int argc,char**argv){ using namespace carom; using namespace carom::properties; GateOptions o; o.cases=argc>1?std::strtoull(argv[1],nullptr,10):100; o.seed=argc>2?std::strtoull(argv[2],nullptr,10):1; o.jobs=2;
 for(auto&f:all_families()) if(argc<4||f.name==argv[3]) o.families.push_back(&f);
 std::vector<Subject> s; for(auto&x:subjects::built_in_subjects()) s.push_back(x);
 auto r=run_gate(s,o);
 for(auto&x:r.results){ auto w=x.worst_backward_error(o); printf("%-28s %6lu viol %zu worst %.3g %s digits %.1f/%.1f/%.1f %.0f ns %s\n",x.subject.name.c_str(),x.cases(),x.violated_invariants().size(),w.backward_error,w.family.c_str(),x.digits_at_least(.5).value_or(0),x.digits_at_least(.99).value_or(0),x.digits_at_least(1).value_or(0),x.nanoseconds_per_solve,x.error.c_str());
  for(auto&v:x.violated_invariants()){ printf("   %s %lu:",v.c_str(),x.count(v).violated); for(size_t f=0;f<x.families.size();++f){auto i=x.families[f].counts.find(v); if(i!=x.families[f].counts.end()&&i->second.violated) printf(" %s=%lu",o.families[f]->name.data(),i->second.violated);} puts("");}
 }
 for(size_t f=0;f<o.families.size();++f){ printf("%-18s",o.families[f]->name.data()); for(auto&x:r.results) printf(" %7.2g",x.families[f].worst_backward_error); puts("");}
}
