struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_11 {
member: u32,
member_1: u32,
}
struct type_12 {
member: type_11,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_13 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_14 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_11,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_11,
member_18: type_12,
member_19: type_5,
member_20: type_13,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: array<f32>,
}
struct type_20 {
member: array<u32>,
}
struct type_21 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_22 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_23 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: i32,
member_10: i32,
member_11: type_2,
member_12: u32,
member_13: type_2,
member_14: u32,
member_15: u32,
}
struct type_24 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_25 {
member: type_5,
member_1: type_5,
}
struct type_26 {
member: type_7,
member_1: u32,
}
struct type_27 {
member: type_2,
member_1: u32,
member_2: type_21,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_22,
member_8: type_23,
member_9: type_23,
member_10: type_24,
member_11: type_25,
member_12: type_14,
member_13: type_22,
member_14: type_4,
member_15: type_9,
member_16: type_26,
member_17: type_26,
member_18: type_26,
member_19: type_26,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_28 {
member: type_27,
}
struct type_29 {
member: vec3<f32>,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_28;
@group(0) @binding(3)
var<storage, read_write> global_2: type_16;
@group(0) @binding(1)
var<storage> global_3: type_20;
@group(0) @binding(2)
var<storage> global_4: type_20;
fn function_() {
var phi_204_: type_11;
var phi_273_: type_11;
var phi_869_: u32;
var phi_1205_: f32;
var phi_1237_: vec3<f32>;
var phi_1263_: f32;
var phi_1374_: f32;
var phi_1458_: f32;
var phi_1530_: type_29;
var phi_1531_: type_29;
switch bitcast<i32>(0u) {
default: {
let _e48 = global;
let _e55 = global_1.member.member_2;
let _e58 = global_1.member.member;
let _e66 = (_e48.x + _e55.member);
let _e68 = (_e48.y + _e55.member_1);
if (_e66 < _e55.member_2) {
if (_e68 < _e55.member_3) {
let _e71 = (_e58.member * _e58.member_1);
let _e73 = ((_e68 * _e58.member) + _e66);
let _e77 = global_1.member.member_3.member;
let _e81 = global_1.member.member_3.member_1;
let _e82 = (_e66 % 16u);
let _e83 = (_e68 % 4u);
if ((_e66 < (_e77 - (_e77 % 16u))) && (_e68 < (_e81 - (_e81 % 4u)))) {
phi_204_ = type_11((((_e66 - _e82) + (_e83 * 4u)) + (_e82 % 4u)), ((_e68 - _e83) + (_e82 / 4u)));
} else {
phi_204_ = type_11(_e66, _e68);
}
let _e102 = phi_204_;
let _e107 = global_1.member.member_5;
let _e108 = (_e107 == 0u);
let _e109 = select(_e107, 1u, _e108);
let _e110 = (_e109 == 0u);
if _e110 {
break;
}
if _e110 {
break;
}
if _e110 {
break;
}
let _e116 = bitcast<i32>((((_e102.member_1 / _e109) * (_e77 / _e109)) + (_e102.member / _e109)));
let _e118 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e120 = select(_e118, _e116, (_e116 < _e118));
let _e126 = global_4.member[bitcast<u32>(select(0i, _e120, (_e120 > 0i)))];
if _e108 {
phi_273_ = _e102;
} else {
if _e110 {
break;
}
if _e110 {
break;
}
phi_273_ = type_11((((_e126 & 65535u) * _e109) + (_e102.member % _e109)), (((_e126 >> bitcast<u32>(16u)) * _e109) + (_e102.member_1 % _e109)));
}
let _e138 = phi_273_;
let _e147 = global_1.member.member_4.member;
let _e156 = global_1.member.member_14.member;
let _e157 = (((((f32(bitcast<i32>(_e138.member)) + 0.5f) / f32(bitcast<i32>(_e147))) * 2f) - 1f) * _e156);
let _e164 = global_1.member.member_4.member_1;
let _e173 = global_1.member.member_14.member_1;
let _e174 = ((1f - (((f32(bitcast<i32>(_e138.member_1)) + 0.5f) / f32(bitcast<i32>(_e164))) * 2f)) * _e173);
let _e178 = global_1.member.member_14.member_3;
let _e179 = (_e178 != 0u);
let _e183 = global_1.member.member_14.member_2;
let _e184 = select(_e157, 0f, _e179);
let _e185 = select(_e174, 0f, _e179);
let _e186 = select(0f, _e157, _e179);
let _e187 = select(0f, _e174, _e179);
let _e191 = (_e186 + (_e184 * _e183));
let _e192 = (_e187 + (_e185 * _e183));
let _e193 = (0f + (1f * _e183));
let _e198 = (((_e184 * _e184) + (_e185 * _e185)) + (1f * 1f));
let _e201 = sqrt(select(0f, _e198, (_e198 > 0f)));
let _e204 = (1f / select(1e-20f, _e201, (_e201 > 1e-20f)));
let _e212 = global_1.member.member_15.member.member;
let _e223 = ((((_e212.member.member * _e186) + (_e212.member.member_1 * _e187)) + (_e212.member.member_2 * 0f)) + _e212.member_1);
let _e229 = ((((_e212.member.member * _e191) + (_e212.member.member_1 * _e192)) + (_e212.member.member_2 * _e193)) + _e212.member_1);
let _e232 = ((_e223 > 0f) && (_e229 <= 0f));
let _e233 = (_e223 - _e229);
let _e236 = (_e223 / select(1e-20f, _e233, (_e233 > 1e-20f)));
let _e241 = global_1.member.member_15.member_1.member;
let _e252 = ((((_e241.member.member * _e186) + (_e241.member.member_1 * _e187)) + (_e241.member.member_2 * 0f)) + _e241.member_1);
let _e258 = ((((_e241.member.member * _e191) + (_e241.member.member_1 * _e192)) + (_e241.member.member_2 * _e193)) + _e241.member_1);
let _e261 = ((_e252 > 0f) && (_e258 <= 0f));
let _e262 = (_e252 - _e258);
let _e265 = (_e252 / select(1e-20f, _e262, (_e262 > 1e-20f)));
let _e269 = (_e261 && (!(_e232) || (_e265 < _e236)));
let _e275 = global_1.member.member_15.member_1.member.member;
let _e280 = global_1.member.member_15.member_1.member_1;
let _e286 = global_1.member.member_15.member.member.member;
let _e291 = global_1.member.member_15.member.member_1;
let _e298 = select(_e286.member, _e275.member, _e269);
let _e299 = select(_e286.member_1, _e275.member_1, _e269);
let _e300 = select(_e286.member_2, _e275.member_2, _e269);
let _e310 = select(_e236, _e265, _e269);
let _e311 = (_e232 || _e261);
let _e316 = select(1f, _e310, (_e310 < 1f));
let _e320 = (_e186 + ((_e191 - _e186) * _e316));
let _e321 = (_e187 + ((_e192 - _e187) * _e316));
let _e322 = (0f + ((_e193 - 0f) * _e316));
let _e326 = global_1.member.member_12.member;
let _e337 = ((((_e326.member.member * _e320) + (_e326.member.member_1 * _e321)) + (_e326.member.member_2 * _e322)) + _e326.member_1);
let _e341 = global_1.member.member_12.member_1;
let _e352 = ((((_e341.member.member * _e320) + (_e341.member.member_1 * _e321)) + (_e341.member.member_2 * _e322)) + _e341.member_1);
let _e356 = global_1.member.member_12.member_2;
let _e367 = ((((_e356.member.member * _e320) + (_e356.member.member_1 * _e321)) + (_e356.member.member_2 * _e322)) + _e356.member_1);
let _e371 = global_1.member.member_12.member_3;
let _e372 = (_e371 != 0u);
let _e376 = global_1.member.member_12.member_19;
let _e380 = (_e337 - _e376.member);
let _e381 = (_e352 - _e376.member_1);
let _e382 = (_e367 - _e376.member_2);
let _e387 = (((_e380 * _e380) + (_e381 * _e381)) + (_e382 * _e382));
let _e390 = sqrt(select(0f, _e387, (_e387 > 0f)));
let _e393 = (1f / select(1e-20f, _e390, (_e390 > 1e-20f)));
let _e397 = select(0f, (_e380 * _e393), _e372);
let _e398 = select(0f, (_e381 * _e393), _e372);
let _e399 = select(1f, (_e382 * _e393), _e372);
let _e404 = global_1.member.member_12.member.member;
let _e415 = global_1.member.member_12.member_1.member;
let _e429 = global_1.member.member_12.member_2.member;
let _e438 = (vec3<f32>(((_e404.member * _e397) + (_e415.member * _e398)), ((_e404.member_1 * _e397) + (_e415.member_1 * _e398)), ((_e404.member_2 * _e397) + (_e415.member_2 * _e398))) + vec3<f32>((_e429.member * _e399), (_e429.member_1 * _e399), (_e429.member_2 * _e399)));
let _e441 = global_1.member.member_1;
if ((_e441 & 256u) != 0u) {
let _e449 = global_1.member.member_12.member_18.member.member;
let _e450 = bitcast<i32>(_e449);
let _e456 = global_1.member.member_12.member_18.member.member_1;
let _e457 = bitcast<i32>(_e456);
let _e462 = global_1.member.member_12.member_19.member_2;
let _e464 = select(1f, (_e367 - _e462), _e372);
let _e467 = (1f / select(1e-12f, _e464, (_e464 > 1e-12f)));
let _e472 = global_1.member.member_12.member_5;
let _e477 = global_1.member.member_12.member_8;
let _e478 = (((_e337 * _e467) - _e472) * _e477);
let _e483 = global_1.member.member_12.member_6;
let _e485 = (((_e352 * _e467) - _e483) * _e477);
let _e490 = global_1.member.member_12.member_4.member;
let _e492 = f32(bitcast<i32>(_e490));
let _e494 = select(0f, _e478, (_e478 > 0f));
let _e501 = global_1.member.member_12.member_18.member_1;
let _e504 = ((_e478 - _e492) * _e501);
let _e509 = global_1.member.member_12.member_18.member_2;
let _e511 = select(0f, _e504, (_e504 > 0f));
let _e513 = (_e509 + _e511);
let _e518 = (-(_e478) * _e501);
let _e520 = select(0f, _e518, (_e518 > 0f));
let _e522 = (_e509 + _e520);
let _e529 = (((_e509 + (select(_e492, _e494, (_e494 < _e492)) * _e501)) + (((_e511 * _e509) / select(1e-12f, _e513, (_e513 > 1e-12f))) - ((_e520 * _e509) / select(1e-12f, _e522, (_e522 > 1e-12f))))) - 0.5f);
let _e534 = global_1.member.member_12.member_4.member_1;
let _e536 = f32(bitcast<i32>(_e534));
let _e538 = select(0f, _e485, (_e485 > 0f));
let _e543 = ((_e485 - _e536) * _e501);
let _e545 = select(0f, _e543, (_e543 > 0f));
let _e547 = (_e509 + _e545);
let _e552 = (-(_e485) * _e501);
let _e554 = select(0f, _e552, (_e552 > 0f));
let _e556 = (_e509 + _e554);
let _e563 = (((_e509 + (select(_e536, _e538, (_e538 < _e536)) * _e501)) + (((_e545 * _e509) / select(1e-12f, _e547, (_e547 > 1e-12f))) - ((_e554 * _e509) / select(1e-12f, _e556, (_e556 > 1e-12f))))) - 0.5f);
let _e565 = f32((_e450 - 2i));
let _e567 = select(0f, _e529, (_e529 > 0f));
let _e569 = select(_e565, _e567, (_e567 < _e565));
let _e576 = select(0i, select(select(i32(_e569), i32(-2147483648), (_e569 < -2147483600f)), 2147483647i, (_e569 > 2147483500f)), (_e569 == _e569));
let _e580 = (_e576 - select(0i, 1i, (_e569 < f32(_e576))));
let _e582 = f32((_e457 - 2i));
let _e584 = select(0f, _e563, (_e563 > 0f));
let _e586 = select(_e582, _e584, (_e584 < _e582));
let _e593 = select(0i, select(select(i32(_e586), i32(-2147483648), (_e586 < -2147483600f)), 2147483647i, (_e586 > 2147483500f)), (_e586 == _e586));
let _e597 = (_e593 - select(0i, 1i, (_e586 < f32(_e593))));
let _e599 = (_e529 - f32(_e580));
let _e601 = select(0f, _e599, (_e599 > 0f));
let _e603 = select(1f, _e601, (_e601 < 1f));
let _e605 = (_e563 - f32(_e597));
let _e607 = select(0f, _e605, (_e605 > 0f));
let _e609 = select(1f, _e607, (_e607 < 1f));
if _e269 {
let _e614 = global_1.member.member_12.member_18.member_4;
phi_869_ = _e614;
} else {
let _e619 = global_1.member.member_12.member_18.member_3;
phi_869_ = _e619;
}
let _e621 = phi_869_;
let _e625 = ((bitcast<i32>(_e621) + (_e597 * _e450)) + _e580);
let _e626 = (_e450 * _e457);
let _e628 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e630 = select(_e628, _e625, (_e625 < _e628));
let _e636 = global_3.member[bitcast<u32>(select(0i, _e630, (_e630 > 0i)))];
let _e637 = bitcast<f32>(_e636);
let _e638 = (_e625 + 1i);
let _e640 = select(_e628, _e638, (_e638 < _e628));
let _e646 = global_3.member[bitcast<u32>(select(0i, _e640, (_e640 > 0i)))];
let _e650 = (_e637 + ((bitcast<f32>(_e646) - _e637) * _e603));
let _e651 = (_e625 + _e450);
let _e653 = select(_e628, _e651, (_e651 < _e628));
let _e659 = global_3.member[bitcast<u32>(select(0i, _e653, (_e653 > 0i)))];
let _e660 = bitcast<f32>(_e659);
let _e661 = (_e651 + 1i);
let _e663 = select(_e628, _e661, (_e661 < _e628));
let _e669 = global_3.member[bitcast<u32>(select(0i, _e663, (_e663 > 0i)))];
let _e676 = (_e650 + (((_e660 + ((bitcast<f32>(_e669) - _e660) * _e603)) - _e650) * _e609));
let _e677 = (_e625 + _e626);
let _e679 = select(_e628, _e677, (_e677 < _e628));
let _e685 = global_3.member[bitcast<u32>(select(0i, _e679, (_e679 > 0i)))];
let _e686 = bitcast<f32>(_e685);
let _e687 = (_e677 + 1i);
let _e689 = select(_e628, _e687, (_e687 < _e628));
let _e695 = global_3.member[bitcast<u32>(select(0i, _e689, (_e689 > 0i)))];
let _e699 = (_e686 + ((bitcast<f32>(_e695) - _e686) * _e603));
let _e700 = (_e677 + _e450);
let _e702 = select(_e628, _e700, (_e700 < _e628));
let _e708 = global_3.member[bitcast<u32>(select(0i, _e702, (_e702 > 0i)))];
let _e709 = bitcast<f32>(_e708);
let _e710 = (_e700 + 1i);
let _e712 = select(_e628, _e710, (_e710 < _e628));
let _e718 = global_3.member[bitcast<u32>(select(0i, _e712, (_e712 > 0i)))];
let _e725 = (_e699 + (((_e709 + ((bitcast<f32>(_e718) - _e709) * _e603)) - _e699) * _e609));
let _e727 = (_e625 + (2i * _e626));
let _e729 = select(_e628, _e727, (_e727 < _e628));
let _e735 = global_3.member[bitcast<u32>(select(0i, _e729, (_e729 > 0i)))];
let _e736 = bitcast<f32>(_e735);
let _e737 = (_e727 + 1i);
let _e739 = select(_e628, _e737, (_e737 < _e628));
let _e745 = global_3.member[bitcast<u32>(select(0i, _e739, (_e739 > 0i)))];
let _e749 = (_e736 + ((bitcast<f32>(_e745) - _e736) * _e603));
let _e750 = (_e727 + _e450);
let _e752 = select(_e628, _e750, (_e750 < _e628));
let _e758 = global_3.member[bitcast<u32>(select(0i, _e752, (_e752 > 0i)))];
let _e759 = bitcast<f32>(_e758);
let _e760 = (_e750 + 1i);
let _e762 = select(_e628, _e760, (_e760 < _e628));
let _e768 = global_3.member[bitcast<u32>(select(0i, _e762, (_e762 > 0i)))];
let _e775 = (_e749 + (((_e759 + ((bitcast<f32>(_e768) - _e759) * _e603)) - _e749) * _e609));
let _e777 = (_e371 == 0u);
if _e777 {
phi_1237_ = vec3<f32>(_e676, _e725, _e775);
} else {
if _e777 {
phi_1205_ = 1f;
} else {
let _e782 = global_1.member.member_12.member_20.member;
let _e790 = (((_e782.member * _e380) + (_e782.member_1 * _e381)) + (_e782.member_2 * _e382));
let _e794 = (_e380 - (_e782.member * _e790));
let _e795 = (_e381 - (_e782.member_1 * _e790));
let _e796 = (_e382 - (_e782.member_2 * _e790));
let _e801 = (((_e794 * _e794) + (_e795 * _e795)) + (_e796 * _e796));
let _e812 = global_1.member.member_12.member_20.member_1;
let _e818 = global_1.member.member_12.member_20.member_2;
let _e819 = ((_e812 - (sqrt(select(0f, _e801, (_e801 > 0f))) / select(1e-20f, _e790, (_e790 > 1e-20f)))) * _e818);
let _e821 = select(0f, _e819, (_e819 > 0f));
let _e823 = select(1f, _e821, (_e821 < 1f));
phi_1205_ = select(1f, select(0f, ((_e823 * _e823) * (3f - (2f * _e823))), (_e790 > 0f)), (_e818 > 0f));
}
let _e833 = phi_1205_;
let _e835 = select(0f, 1f, (_e382 > 0f));
let _e839 = ((_e676 * _e835) + _e833);
let _e840 = ((_e725 * _e835) + _e833);
let _e841 = ((_e775 * _e835) + _e833);
phi_1237_ = vec3<f32>(select(0f, _e839, (_e839 > 0f)), select(0f, _e840, (_e840 > 0f)), select(0f, _e841, (_e841 > 0f)));
}
let _e850 = phi_1237_;
if _e777 {
phi_1263_ = 1f;
} else {
phi_1263_ = (1f / select(1e-12f, _e387, (_e387 > 1e-12f)));
}
let _e855 = phi_1263_;
let _e865 = global_1.member.member_11.member_1;
phi_1531_ = type_29(vec3<f32>((_e865.member * (_e850.x * _e855)), (_e865.member_1 * (_e850.y * _e855)), (_e865.member_2 * (_e850.z * _e855))), _e438);
} else {
let _e874 = (_e371 == 0u);
if _e874 {
let _e878 = global_1.member.member_11.member_1;
let _e886 = global_1.member.member_11.member;
phi_1530_ = type_29(vec3<f32>(_e878.member, _e878.member_1, _e878.member_2), vec3<f32>(_e886.member, _e886.member_1, _e886.member_2));
} else {
let _e895 = global_1.member.member_11.member_1;
if _e874 {
phi_1374_ = 1f;
} else {
phi_1374_ = (1f / select(1e-12f, _e387, (_e387 > 1e-12f)));
}
let _e903 = phi_1374_;
if _e874 {
phi_1458_ = 1f;
} else {
let _e908 = global_1.member.member_12.member_20.member;
let _e916 = (((_e908.member * _e380) + (_e908.member_1 * _e381)) + (_e908.member_2 * _e382));
let _e920 = (_e380 - (_e908.member * _e916));
let _e921 = (_e381 - (_e908.member_1 * _e916));
let _e922 = (_e382 - (_e908.member_2 * _e916));
let _e927 = (((_e920 * _e920) + (_e921 * _e921)) + (_e922 * _e922));
let _e938 = global_1.member.member_12.member_20.member_1;
let _e944 = global_1.member.member_12.member_20.member_2;
let _e945 = ((_e938 - (sqrt(select(0f, _e927, (_e927 > 0f))) / select(1e-20f, _e916, (_e916 > 1e-20f)))) * _e944);
let _e947 = select(0f, _e945, (_e945 > 0f));
let _e949 = select(1f, _e947, (_e947 < 1f));
phi_1458_ = select(1f, select(0f, ((_e949 * _e949) * (3f - (2f * _e949))), (_e916 > 0f)), (_e944 > 0f));
}
let _e959 = phi_1458_;
let _e960 = (_e903 * _e959);
phi_1530_ = type_29(vec3<f32>((_e895.member * _e960), (_e895.member_1 * _e960), (_e895.member_2 * _e960)), _e438);
}
let _e967 = phi_1530_;
phi_1531_ = _e967;
}
let _e969 = phi_1531_;
let _e973 = global_1.member.member_23.member_4;
let _e981 = (((_e973.member * _e298) + (_e973.member_1 * _e299)) + (_e973.member_2 * _e300));
let _e985 = global_1.member.member_23.member_5;
let _e993 = (((_e985.member * _e298) + (_e985.member_1 * _e299)) + (_e985.member_2 * _e300));
let _e997 = global_1.member.member_23.member_6;
let _e1005 = (((_e997.member * _e298) + (_e997.member_1 * _e299)) + (_e997.member_2 * _e300));
let _e1009 = global_1.member.member_20.member_1;
let _e1019 = global_1.member.member_20.member_2;
let _e1032 = global_1.member.member_20.member_3;
let _e1045 = global_1.member.member_20.member_4;
let _e1049 = (_e981 * _e981);
let _e1056 = global_1.member.member_20.member_5;
let _e1060 = (_e993 * _e993);
let _e1070 = global_1.member.member_20.member_6;
let _e1074 = (_e1005 * _e1005);
let _e1084 = global_1.member.member_20.member_7;
let _e1088 = (_e981 * _e993);
let _e1095 = global_1.member.member_20.member_8;
let _e1099 = (_e981 * _e1005);
let _e1109 = global_1.member.member_20.member_9;
let _e1113 = (_e993 * _e1005);
let _e1123 = global_1.member.member_20.member;
let _e1133 = ((_e1123.member + (((_e1009.member * _e981) + (_e1019.member * _e993)) + (_e1032.member * _e1005))) + ((((_e1045.member * _e1049) + (_e1056.member * _e1060)) + (_e1070.member * _e1074)) + (((_e1084.member * _e1088) + (_e1095.member * _e1099)) + (_e1109.member * _e1113))));
let _e1134 = ((_e1123.member_1 + (((_e1009.member_1 * _e981) + (_e1019.member_1 * _e993)) + (_e1032.member_1 * _e1005))) + ((((_e1045.member_1 * _e1049) + (_e1056.member_1 * _e1060)) + (_e1070.member_1 * _e1074)) + (((_e1084.member_1 * _e1088) + (_e1095.member_1 * _e1099)) + (_e1109.member_1 * _e1113))));
let _e1135 = ((_e1123.member_2 + (((_e1009.member_2 * _e981) + (_e1019.member_2 * _e993)) + (_e1032.member_2 * _e1005))) + ((((_e1045.member_2 * _e1049) + (_e1056.member_2 * _e1060)) + (_e1070.member_2 * _e1074)) + (((_e1084.member_2 * _e1088) + (_e1095.member_2 * _e1099)) + (_e1109.member_2 * _e1113))));
let _e1150 = (((_e969.member_1.x * _e969.member_1.x) + (_e969.member_1.y * _e969.member_1.y)) + (_e969.member_1.z * _e969.member_1.z));
let _e1153 = sqrt(select(0f, _e1150, (_e1150 > 0f)));
let _e1159 = (1e-6f * _e1153);
let _e1163 = select((_e1153 / select(_e1159, _e969.member_1.z, (_e969.member_1.z > _e1159))), 1f, ((_e441 & 8u) != 0u));
let _e1178 = (-((((_e298 * _e969.member_1.x) + (_e299 * _e969.member_1.y)) + (_e300 * _e969.member_1.z))) / select(1e-20f, _e1153, (_e1153 > 1e-20f)));
let _e1183 = bitcast<f32>((bitcast<u32>(select(0f, _e1178, (_e1178 > 0f))) & 2147483647u));
let _e1193 = select(0f, 1f, _e311);
global_2.member[_e73] = _e191;
global_2.member[(_e71 + _e73)] = _e192;
global_2.member[((2u * _e71) + _e73)] = _e193;
global_2.member[((3u * _e71) + _e73)] = (_e184 * _e204);
global_2.member[((4u * _e71) + _e73)] = (_e185 * _e204);
global_2.member[((5u * _e71) + _e73)] = (1f * _e204);
global_2.member[((6u * _e71) + _e73)] = 0f;
global_2.member[((7u * _e71) + _e73)] = _e1193;
global_2.member[((8u * _e71) + _e73)] = select(0f, (_e310 * _e183), _e311);
global_2.member[((9u * _e71) + _e73)] = select(0f, (select(_e291.member, _e280.member, _e269) * (((_e969.member.x * _e1163) * _e1183) + select(0f, _e1133, (_e1133 > 0f)))), _e311);
global_2.member[((10u * _e71) + _e73)] = select(0f, (select(_e291.member_1, _e280.member_1, _e269) * (((_e969.member.y * _e1163) * _e1183) + select(0f, _e1134, (_e1134 > 0f)))), _e311);
global_2.member[((11u * _e71) + _e73)] = select(0f, (select(_e291.member_2, _e280.member_2, _e269) * (((_e969.member.z * _e1163) * _e1183) + select(0f, _e1135, (_e1135 > 0f)))), _e311);
global_2.member[((12u * _e71) + _e73)] = _e1193;
global_2.member[((13u * _e71) + _e73)] = 1f;
global_2.member[((14u * _e71) + _e73)] = 1f;
global_2.member[((15u * _e71) + _e73)] = 1f;
global_2.member[((16u * _e71) + _e73)] = 0f;
global_2.member[((17u * _e71) + _e73)] = -1.2676506e30f;
global_2.member[((18u * _e71) + _e73)] = 0f;
global_2.member[((19u * _e71) + _e73)] = 0f;
global_2.member[((20u * _e71) + _e73)] = 0f;
global_2.member[((21u * _e71) + _e73)] = 0f;
global_2.member[((22u * _e71) + _e73)] = 0f;
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
