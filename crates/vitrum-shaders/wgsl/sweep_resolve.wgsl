struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_6 {
member: array<f32>,
}
struct type_10 {
member: type_4,
member_1: type_4,
member_2: type_4,
member_3: type_4,
member_4: type_4,
member_5: vec4<i32>,
member_6: vec4<i32>,
member_7: vec4<i32>,
}
struct type_11 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
member_4: type_4,
member_5: type_10,
member_6: type_10,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: type_4,
member_11: type_4,
member_12: type_4,
member_13: type_4,
member_14: type_4,
member_15: type_4,
member_16: type_4,
member_17: type_4,
member_18: type_4,
member_19: type_4,
member_20: type_4,
member_21: type_4,
member_22: type_4,
member_23: type_4,
member_24: type_4,
member_25: vec4<u32>,
member_26: type_4,
member_27: type_4,
member_28: type_4,
member_29: type_4,
member_30: type_4,
member_31: type_4,
}
struct type_12 {
member: type_11,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_12;
@group(0) @binding(1)
var<storage> global_2: type_6;
@group(0) @binding(2)
var<storage> global_3: type_6;
@group(0) @binding(3)
var<storage, read_write> global_4: type_6;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var phi_211_: u32;
var phi_968_: i32;
var phi_976_: i32;
var phi_982_: i32;
var phi_990_: i32;
var phi_1031_: u32;
var phi_1198_: u32;
var phi_1379_: u32;
var phi_1546_: u32;
var phi_1745_: vec3<f32>;
var phi_2342_: i32;
var phi_2345_: i32;
var phi_2347_: i32;
var phi_2349_: i32;
var phi_2364_: i32;
var phi_2370_: i32;
var phi_2343_: i32;
var phi_2346_: i32;
var phi_2348_: i32;
var phi_2350_: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var phi_2445_: i32;
var local_15: i32;
var local_16: i32;
var phi_2451_: i32;
var local_17: i32;
var phi_2458_: i32;
var local_18: i32;
var local_19: i32;
var phi_2464_: i32;
var local_20: i32;
var local_21: i32;
var phi_2475_: i32;
var local_22: i32;
var local_23: i32;
var phi_2487_: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var phi_2721_: i32;
var phi_2724_: i32;
var phi_2726_: i32;
var phi_2728_: i32;
var phi_2743_: i32;
var phi_2749_: i32;
var phi_2722_: i32;
var phi_2725_: i32;
var phi_2727_: i32;
var phi_2729_: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var phi_2824_: i32;
var local_31: i32;
var local_32: i32;
var phi_2830_: i32;
var local_33: i32;
var phi_2837_: i32;
var local_34: i32;
var local_35: i32;
var phi_2843_: i32;
var local_36: i32;
var local_37: i32;
var phi_2854_: i32;
var local_38: i32;
var local_39: i32;
var phi_2866_: i32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var phi_3120_: vec3<f32>;
var phi_3121_: vec3<f32>;
var phi_3122_: vec3<f32>;
let _e92 = global;
let _e101 = global_1.member.member_1;
let _e104 = (_e92.x + _e101.x);
let _e107 = (_e92.y + _e101.y);
if (_e104 < _e101.z) {
if (_e107 < _e101.w) {
let _e115 = global_1.member.member[0u];
let _e119 = global_1.member.member[1u];
let _e120 = (_e115 * _e119);
let _e122 = ((_e107 * _e115) + _e104);
let _e126 = global_1.member.member_2[0u];
let _e130 = global_1.member.member_2[1u];
let _e131 = (_e104 % 16u);
let _e132 = (_e107 % 4u);
if ((_e104 < (_e126 - (_e126 % 16u))) && (_e107 < (_e130 - (_e130 % 4u)))) {
phi_211_ = ((((_e107 - _e132) + (_e131 / 4u)) * _e126) + (((_e104 - _e131) + (_e132 * 4u)) + (_e131 % 4u)));
} else {
phi_211_ = ((_e107 * _e126) + _e104);
}
let _e153 = phi_211_;
local_10 = bitcast<i32>(_e153);
let _e156 = bitcast<i32>((_e126 * _e130));
local_11 = _e156;
let _e157 = local_11;
let _e159 = local_10;
let _e160 = ((6i * _e157) + _e159);
let _e162 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e164 = select(_e162, _e160, (_e160 < _e162));
let _e169 = global_2.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e170 = local_11;
let _e172 = local_10;
let _e173 = ((8i * _e170) + _e172);
let _e175 = select(_e162, _e173, (_e173 < _e162));
let _e180 = global_2.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
let _e181 = local_11;
let _e183 = local_10;
let _e184 = ((9i * _e181) + _e183);
let _e186 = select(_e162, _e184, (_e184 < _e162));
let _e191 = global_2.member[bitcast<u32>(select(0i, _e186, (_e186 > 0i)))];
let _e192 = local_11;
let _e194 = local_10;
let _e195 = ((10i * _e192) + _e194);
let _e197 = select(_e162, _e195, (_e195 < _e162));
let _e202 = global_2.member[bitcast<u32>(select(0i, _e197, (_e197 > 0i)))];
let _e203 = local_11;
let _e205 = local_10;
let _e206 = ((11i * _e203) + _e205);
let _e208 = select(_e162, _e206, (_e206 < _e162));
let _e213 = global_2.member[bitcast<u32>(select(0i, _e208, (_e208 > 0i)))];
let _e214 = local_11;
let _e216 = local_10;
let _e217 = ((7i * _e214) + _e216);
let _e219 = select(_e162, _e217, (_e217 < _e162));
let _e224 = global_2.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
let _e225 = local_11;
let _e227 = local_10;
let _e228 = ((12i * _e225) + _e227);
let _e230 = select(_e162, _e228, (_e228 < _e162));
let _e235 = global_2.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e236 = local_11;
let _e238 = local_10;
let _e239 = ((13i * _e236) + _e238);
let _e241 = select(_e162, _e239, (_e239 < _e162));
let _e246 = global_2.member[bitcast<u32>(select(0i, _e241, (_e241 > 0i)))];
let _e247 = local_11;
let _e249 = local_10;
let _e250 = ((14i * _e247) + _e249);
let _e252 = select(_e162, _e250, (_e250 < _e162));
let _e257 = global_2.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e258 = local_11;
let _e260 = local_10;
let _e261 = ((2i * _e258) + _e260);
let _e263 = select(_e162, _e261, (_e261 < _e162));
let _e268 = global_2.member[bitcast<u32>(select(0i, _e263, (_e263 > 0i)))];
let _e269 = local_11;
let _e271 = local_10;
let _e272 = ((3i * _e269) + _e271);
let _e274 = select(_e162, _e272, (_e272 < _e162));
let _e279 = global_2.member[bitcast<u32>(select(0i, _e274, (_e274 > 0i)))];
let _e280 = local_11;
let _e282 = local_10;
let _e283 = ((4i * _e280) + _e282);
let _e285 = select(_e162, _e283, (_e283 < _e162));
let _e290 = global_2.member[bitcast<u32>(select(0i, _e285, (_e285 > 0i)))];
let _e295 = (((_e268 * _e268) + (_e279 * _e279)) + (_e290 * _e290));
let _e298 = sqrt(select(0f, _e295, (_e295 > 0f)));
let _e301 = (1f / select(1e-20f, _e298, (_e298 > 1e-20f)));
let _e302 = (_e268 * _e301);
let _e303 = (_e279 * _e301);
let _e304 = (_e290 * _e301);
let _e305 = (_e169 == 0f);
let _e306 = local_10;
let _e308 = select(_e162, _e306, (_e306 < _e162));
let _e313 = global_2.member[bitcast<u32>(select(0i, _e308, (_e308 > 0i)))];
let _e314 = local_11;
let _e315 = local_10;
let _e316 = (_e314 + _e315);
let _e318 = select(_e162, _e316, (_e316 < _e162));
let _e323 = global_2.member[bitcast<u32>(select(0i, _e318, (_e318 > 0i)))];
let _e324 = local_11;
let _e326 = local_10;
let _e327 = ((16i * _e324) + _e326);
let _e329 = select(_e162, _e327, (_e327 < _e162));
let _e334 = global_2.member[bitcast<u32>(select(0i, _e329, (_e329 > 0i)))];
let _e338 = global_1.member.member_4.member_1;
let _e341 = select(0f, ((_e338 - _e334) / _e290), _e305);
let _e345 = (_e313 + (_e268 * _e341));
let _e346 = (_e323 + (_e279 * _e341));
let _e347 = (_e334 + (_e290 * _e341));
let _e350 = global_1.member.member_14;
let _e360 = ((((_e350.member * _e345) + (_e350.member_1 * _e346)) + (_e350.member_2 * _e347)) + _e350.member_3);
let _e366 = -((((_e350.member * _e302) + (_e350.member_1 * _e303)) + (_e350.member_2 * _e304)));
let _e368 = (_e366 > 1e-9f);
let _e369 = ((_e360 > 0f) && _e368);
let _e371 = (_e360 / select(1e-9f, _e366, _e368));
let _e374 = global_1.member.member_16;
let _e384 = ((((_e374.member * _e345) + (_e374.member_1 * _e346)) + (_e374.member_2 * _e347)) + _e374.member_3);
let _e390 = -((((_e374.member * _e302) + (_e374.member_1 * _e303)) + (_e374.member_2 * _e304)));
let _e392 = (_e390 > 1e-9f);
let _e393 = ((_e384 > 0f) && _e392);
let _e395 = (_e384 / select(1e-9f, _e390, _e392));
let _e399 = (_e393 && (!(_e369) || (_e395 < _e371)));
let _e407 = global_1.member.member_17;
let _e410 = global_1.member.member_15;
let _e422 = global_1.member.member_9;
let _e428 = global_1.member.member_10;
let _e442 = (((_e428.member * _e428.member) + (_e428.member_1 * _e428.member_1)) + (_e428.member_2 * _e428.member_2));
let _e445 = sqrt(select(0f, _e442, (_e442 > 0f)));
let _e448 = (-((((select(_e350.member, _e374.member, _e399) * _e428.member) + (select(_e350.member_1, _e374.member_1, _e399) * _e428.member_1)) + (select(_e350.member_2, _e374.member_2, _e399) * _e428.member_2))) / select(1e-20f, _e445, (_e445 > 1e-20f)));
let _e454 = global_1.member.member[3u];
let _e457 = (1e-6f * _e445);
let _e461 = select((_e445 / select(_e457, _e428.member_2, (_e428.member_2 > _e457))), 1f, ((_e454 & 8u) != 0u));
let _e467 = bitcast<f32>((bitcast<u32>(select(0f, _e448, (_e448 > 0f))) & 2147483647u));
let _e473 = global_1.member.member_23;
let _e485 = select(0f, (1f - _e213), (_e305 && (_e369 || _e393)));
let _e495 = (_e213 + _e485);
let _e500 = (1f - _e495);
let _e503 = global_1.member.member_25;
let _e506 = global_1.member.member_29;
let _e509 = global_1.member.member_30;
let _e512 = global_1.member.member_31;
let _e513 = local_10;
local_8 = _e513;
local_9 = _e156;
let _e514 = local_9;
let _e516 = local_8;
let _e517 = ((2i * _e514) + _e516);
let _e519 = select(_e162, _e517, (_e517 < _e162));
let _e524 = global_2.member[bitcast<u32>(select(0i, _e519, (_e519 > 0i)))];
let _e525 = local_9;
let _e527 = local_8;
let _e528 = ((3i * _e525) + _e527);
let _e530 = select(_e162, _e528, (_e528 < _e162));
let _e535 = global_2.member[bitcast<u32>(select(0i, _e530, (_e530 > 0i)))];
let _e536 = local_9;
let _e538 = local_8;
let _e539 = ((4i * _e536) + _e538);
let _e541 = select(_e162, _e539, (_e539 < _e162));
let _e546 = global_2.member[bitcast<u32>(select(0i, _e541, (_e541 > 0i)))];
let _e551 = (((_e524 * _e524) + (_e535 * _e535)) + (_e546 * _e546));
let _e554 = sqrt(select(0f, _e551, (_e551 > 0f)));
let _e557 = (1f / select(1e-20f, _e554, (_e554 > 1e-20f)));
let _e558 = (_e524 * _e557);
let _e559 = (_e535 * _e557);
let _e560 = (_e546 * _e557);
let _e563 = global_1.member.member_26;
let _e571 = (((_e563.member * _e558) + (_e563.member_1 * _e559)) + (_e563.member_2 * _e560));
let _e574 = global_1.member.member_27;
let _e582 = (((_e574.member * _e558) + (_e574.member_1 * _e559)) + (_e574.member_2 * _e560));
let _e585 = global_1.member.member_28;
let _e593 = (((_e585.member * _e558) + (_e585.member_1 * _e559)) + (_e585.member_2 * _e560));
let _e594 = bitcast<i32>(_e104);
let _e595 = bitcast<i32>(_e107);
if (_e594 > 0i) {
phi_968_ = (_e594 - 1i);
} else {
phi_968_ = 0i;
}
let _e601 = phi_968_;
let _e602 = (bitcast<i32>(_e126) - 1i);
if (_e594 < _e602) {
phi_976_ = (_e594 + 1i);
} else {
phi_976_ = _e602;
}
let _e606 = phi_976_;
if (_e595 > 0i) {
phi_982_ = (_e595 - 1i);
} else {
phi_982_ = 0i;
}
let _e610 = phi_982_;
let _e611 = (bitcast<i32>(_e130) - 1i);
if (_e595 < _e611) {
phi_990_ = (_e595 + 1i);
} else {
phi_990_ = _e611;
}
let _e615 = phi_990_;
let _e618 = global_1.member.member_2[0u];
let _e621 = global_1.member.member_2[1u];
let _e622 = bitcast<u32>(_e606);
let _e623 = bitcast<u32>(_e595);
let _e624 = (_e622 % 16u);
let _e625 = (_e623 % 4u);
let _e627 = (_e618 - (_e618 % 16u));
let _e630 = (_e621 - (_e621 % 4u));
let _e631 = (_e623 < _e630);
if ((_e622 < _e627) && _e631) {
phi_1031_ = ((((_e623 - _e625) + (_e624 / 4u)) * _e618) + (((_e622 - _e624) + (_e625 * 4u)) + (_e624 % 4u)));
} else {
phi_1031_ = ((_e623 * _e618) + _e622);
}
let _e646 = phi_1031_;
local_6 = bitcast<i32>(_e646);
let _e649 = bitcast<i32>((_e618 * _e621));
local_7 = _e649;
let _e650 = local_7;
let _e652 = local_6;
let _e653 = ((2i * _e650) + _e652);
let _e655 = select(_e162, _e653, (_e653 < _e162));
let _e660 = global_2.member[bitcast<u32>(select(0i, _e655, (_e655 > 0i)))];
let _e661 = local_7;
let _e663 = local_6;
let _e664 = ((3i * _e661) + _e663);
let _e666 = select(_e162, _e664, (_e664 < _e162));
let _e671 = global_2.member[bitcast<u32>(select(0i, _e666, (_e666 > 0i)))];
let _e672 = local_7;
let _e674 = local_6;
let _e675 = ((4i * _e672) + _e674);
let _e677 = select(_e162, _e675, (_e675 < _e162));
let _e682 = global_2.member[bitcast<u32>(select(0i, _e677, (_e677 > 0i)))];
let _e687 = (((_e660 * _e660) + (_e671 * _e671)) + (_e682 * _e682));
let _e690 = sqrt(select(0f, _e687, (_e687 > 0f)));
let _e693 = (1f / select(1e-20f, _e690, (_e690 > 1e-20f)));
let _e694 = (_e660 * _e693);
let _e695 = (_e671 * _e693);
let _e696 = (_e682 * _e693);
let _e698 = global_1.member.member_26;
let _e708 = global_1.member.member_27;
let _e718 = global_1.member.member_28;
let _e727 = bitcast<u32>(_e601);
let _e728 = (_e727 % 16u);
if ((_e727 < _e627) && _e631) {
phi_1198_ = ((((_e623 - _e625) + (_e728 / 4u)) * _e618) + (((_e727 - _e728) + (_e625 * 4u)) + (_e728 % 4u)));
} else {
phi_1198_ = ((_e623 * _e618) + _e727);
}
let _e744 = phi_1198_;
local_4 = bitcast<i32>(_e744);
local_5 = _e649;
let _e746 = local_5;
let _e748 = local_4;
let _e749 = ((2i * _e746) + _e748);
let _e751 = select(_e162, _e749, (_e749 < _e162));
let _e756 = global_2.member[bitcast<u32>(select(0i, _e751, (_e751 > 0i)))];
let _e757 = local_5;
let _e759 = local_4;
let _e760 = ((3i * _e757) + _e759);
let _e762 = select(_e162, _e760, (_e760 < _e162));
let _e767 = global_2.member[bitcast<u32>(select(0i, _e762, (_e762 > 0i)))];
let _e768 = local_5;
let _e770 = local_4;
let _e771 = ((4i * _e768) + _e770);
let _e773 = select(_e162, _e771, (_e771 < _e162));
let _e778 = global_2.member[bitcast<u32>(select(0i, _e773, (_e773 > 0i)))];
let _e783 = (((_e756 * _e756) + (_e767 * _e767)) + (_e778 * _e778));
let _e786 = sqrt(select(0f, _e783, (_e783 > 0f)));
let _e789 = (1f / select(1e-20f, _e786, (_e786 > 1e-20f)));
let _e790 = (_e756 * _e789);
let _e791 = (_e767 * _e789);
let _e792 = (_e778 * _e789);
let _e808 = ((((_e698.member * _e694) + (_e698.member_1 * _e695)) + (_e698.member_2 * _e696)) - (((_e698.member * _e790) + (_e698.member_1 * _e791)) + (_e698.member_2 * _e792)));
let _e809 = ((((_e708.member * _e694) + (_e708.member_1 * _e695)) + (_e708.member_2 * _e696)) - (((_e708.member * _e790) + (_e708.member_1 * _e791)) + (_e708.member_2 * _e792)));
let _e810 = ((((_e718.member * _e694) + (_e718.member_1 * _e695)) + (_e718.member_2 * _e696)) - (((_e718.member * _e790) + (_e718.member_1 * _e791)) + (_e718.member_2 * _e792)));
let _e815 = (((_e808 * _e808) + (_e809 * _e809)) + (_e810 * _e810));
let _e819 = bitcast<u32>(_e594);
let _e820 = bitcast<u32>(_e615);
let _e821 = (_e819 % 16u);
let _e822 = (_e820 % 4u);
let _e823 = (_e819 < _e627);
if (_e823 && (_e820 < _e630)) {
phi_1379_ = ((((_e820 - _e822) + (_e821 / 4u)) * _e618) + (((_e819 - _e821) + (_e822 * 4u)) + (_e821 % 4u)));
} else {
phi_1379_ = ((_e820 * _e618) + _e819);
}
let _e839 = phi_1379_;
local_2 = bitcast<i32>(_e839);
local_3 = _e649;
let _e841 = local_3;
let _e843 = local_2;
let _e844 = ((2i * _e841) + _e843);
let _e846 = select(_e162, _e844, (_e844 < _e162));
let _e851 = global_2.member[bitcast<u32>(select(0i, _e846, (_e846 > 0i)))];
let _e852 = local_3;
let _e854 = local_2;
let _e855 = ((3i * _e852) + _e854);
let _e857 = select(_e162, _e855, (_e855 < _e162));
let _e862 = global_2.member[bitcast<u32>(select(0i, _e857, (_e857 > 0i)))];
let _e863 = local_3;
let _e865 = local_2;
let _e866 = ((4i * _e863) + _e865);
let _e868 = select(_e162, _e866, (_e866 < _e162));
let _e873 = global_2.member[bitcast<u32>(select(0i, _e868, (_e868 > 0i)))];
let _e878 = (((_e851 * _e851) + (_e862 * _e862)) + (_e873 * _e873));
let _e881 = sqrt(select(0f, _e878, (_e878 > 0f)));
let _e884 = (1f / select(1e-20f, _e881, (_e881 > 1e-20f)));
let _e885 = (_e851 * _e884);
let _e886 = (_e862 * _e884);
let _e887 = (_e873 * _e884);
let _e903 = bitcast<u32>(_e610);
let _e904 = (_e903 % 4u);
if (_e823 && (_e903 < _e630)) {
phi_1546_ = ((((_e903 - _e904) + (_e821 / 4u)) * _e618) + (((_e819 - _e821) + (_e904 * 4u)) + (_e821 % 4u)));
} else {
phi_1546_ = ((_e903 * _e618) + _e819);
}
let _e920 = phi_1546_;
local = bitcast<i32>(_e920);
local_1 = _e649;
let _e922 = local_1;
let _e924 = local;
let _e925 = ((2i * _e922) + _e924);
let _e927 = select(_e162, _e925, (_e925 < _e162));
let _e932 = global_2.member[bitcast<u32>(select(0i, _e927, (_e927 > 0i)))];
let _e933 = local_1;
let _e935 = local;
let _e936 = ((3i * _e933) + _e935);
let _e938 = select(_e162, _e936, (_e936 < _e162));
let _e943 = global_2.member[bitcast<u32>(select(0i, _e938, (_e938 > 0i)))];
let _e944 = local_1;
let _e946 = local;
let _e947 = ((4i * _e944) + _e946);
let _e949 = select(_e162, _e947, (_e947 < _e162));
let _e954 = global_2.member[bitcast<u32>(select(0i, _e949, (_e949 > 0i)))];
let _e959 = (((_e932 * _e932) + (_e943 * _e943)) + (_e954 * _e954));
let _e962 = sqrt(select(0f, _e959, (_e959 > 0f)));
let _e965 = (1f / select(1e-20f, _e962, (_e962 > 1e-20f)));
let _e966 = (_e932 * _e965);
let _e967 = (_e943 * _e965);
let _e968 = (_e954 * _e965);
let _e984 = ((((_e698.member * _e885) + (_e698.member_1 * _e886)) + (_e698.member_2 * _e887)) - (((_e698.member * _e966) + (_e698.member_1 * _e967)) + (_e698.member_2 * _e968)));
let _e985 = ((((_e708.member * _e885) + (_e708.member_1 * _e886)) + (_e708.member_2 * _e887)) - (((_e708.member * _e966) + (_e708.member_1 * _e967)) + (_e708.member_2 * _e968)));
let _e986 = ((((_e718.member * _e885) + (_e718.member_1 * _e886)) + (_e718.member_2 * _e887)) - (((_e718.member * _e966) + (_e718.member_1 * _e967)) + (_e718.member_2 * _e968)));
let _e991 = (((_e984 * _e984) + (_e985 * _e985)) + (_e986 * _e986));
let _e996 = f32((_e606 - _e601));
let _e999 = (sqrt(select(0f, _e815, (_e815 > 0f))) / select(1f, _e996, (_e996 > 1f)));
let _e1001 = f32((_e615 - _e610));
let _e1004 = (sqrt(select(0f, _e991, (_e991 > 0f))) / select(1f, _e1001, (_e1001 > 1f)));
let _e1006 = select(_e1004, _e999, (_e999 > _e1004));
let _e1011 = vec3<f32>(_e506.member, _e506.member_1, _e506.member_2);
if (_e503.x == 0u) {
phi_3122_ = _e1011;
} else {
if (_e503.x == 1u) {
let _e1018 = select(-1f, _e593, (_e593 > -1f));
let _e1020 = select(1f, _e1018, (_e1018 < 1f));
if (_e1020 > 0f) {
phi_1745_ = _e1011;
} else {
phi_1745_ = vec3<f32>(_e512.member, _e512.member_1, _e512.member_2);
}
let _e1027 = phi_1745_;
let _e1036 = bitcast<f32>((bitcast<u32>(_e1020) & 2147483647u));
let _e1039 = sqrt(select(0f, _e1036, (_e1036 > 0f)));
phi_3121_ = vec3<f32>((_e509.member + ((_e1027.x - _e509.member) * _e1039)), (_e509.member_1 + ((_e1027.y - _e509.member_1) * _e1039)), (_e509.member_2 + ((_e1027.z - _e509.member_2) * _e1039)));
} else {
if (_e503.x == 2u) {
let _e1049 = (_e1006 / _e506.member_3);
let _e1051 = select(1e-4f, _e1049, (_e1049 > 1e-4f));
let _e1054 = bitcast<f32>((bitcast<u32>(_e571) & 2147483647u));
let _e1057 = bitcast<f32>((bitcast<u32>(_e582) & 2147483647u));
let _e1061 = select(_e1057, _e1054, (_e1054 > _e1057));
let _e1064 = (select(_e1057, _e1054, (_e1054 < _e1057)) / select(1.1754944e-38f, _e1061, (_e1061 > 1.1754944e-38f)));
let _e1065 = (_e1064 > 0.41421357f);
let _e1069 = select(_e1064, ((_e1064 - 1f) / (_e1064 + 1f)), _e1065);
let _e1070 = (_e1069 * _e1069);
let _e1085 = (select(0f, 0.7853982f, _e1065) + (_e1069 + ((_e1069 * _e1070) * (-0.33333334f + (_e1070 * (0.2f + (_e1070 * (-0.14285713f + (_e1070 * (0.11111111f + (_e1070 * (-0.09090909f + (_e1070 * 0.0585f)))))))))))));
let _e1088 = select(_e1085, (1.5707964f - _e1085), (_e1057 > _e1054));
let _e1091 = select(_e1088, (3.1415927f - _e1088), (_e571 < 0f));
let _e1097 = (1f - (_e593 * _e593));
let _e1100 = sqrt(select(0f, _e1097, (_e1097 > 0f)));
let _e1103 = (_e1051 / select(1e-3f, _e1100, (_e1100 > 1e-3f)));
let _e1104 = ((select(_e1091, -(_e1091), (_e582 < 0f)) / _e506.member_3) * 0.5f);
let _e1106 = select(-8e6f, _e1104, (_e1104 > -8e6f));
let _e1108 = select(8e6f, _e1106, (_e1106 < 8e6f));
let _e1115 = select(0i, select(select(i32(_e1108), i32(-2147483648), (_e1108 < -2147483600f)), 2147483647i, (_e1108 > 2147483500f)), (_e1108 == _e1108));
let _e1122 = ((_e1104 - f32((_e1115 - select(0i, 1i, (_e1108 < f32(_e1115)))))) * 2f);
let _e1130 = ((select(select((_e1122 - 2f), (1f - _e1122), (_e1122 < 1.5f)), _e1122, (_e1122 < 0.5f)) * 2f) / _e1103);
let _e1132 = select(-1f, _e1130, (_e1130 > -1f));
let _e1135 = (2f - _e1103);
let _e1137 = select(0f, _e1135, (_e1135 > 0f));
let _e1142 = select(-1f, _e593, (_e593 > -1f));
let _e1144 = select(1f, _e1142, (_e1142 < 1f));
let _e1147 = ((1f - _e1144) * (1f + _e1144));
let _e1150 = sqrt(select(0f, _e1147, (_e1147 > 0f)));
let _e1153 = bitcast<f32>((bitcast<u32>(_e1150) & 2147483647u));
let _e1156 = bitcast<f32>((bitcast<u32>(_e1144) & 2147483647u));
let _e1160 = select(_e1156, _e1153, (_e1153 > _e1156));
let _e1163 = (select(_e1156, _e1153, (_e1153 < _e1156)) / select(1.1754944e-38f, _e1160, (_e1160 > 1.1754944e-38f)));
let _e1164 = (_e1163 > 0.41421357f);
let _e1168 = select(_e1163, ((_e1163 - 1f) / (_e1163 + 1f)), _e1164);
let _e1169 = (_e1168 * _e1168);
let _e1184 = (select(0f, 0.7853982f, _e1164) + (_e1168 + ((_e1168 * _e1169) * (-0.33333334f + (_e1169 * (0.2f + (_e1169 * (-0.14285713f + (_e1169 * (0.11111111f + (_e1169 * (-0.09090909f + (_e1169 * 0.0585f)))))))))))));
let _e1187 = select(_e1184, (1.5707964f - _e1184), (_e1156 > _e1153));
let _e1190 = select(_e1187, (3.1415927f - _e1187), (_e1150 < 0f));
let _e1195 = ((select(_e1190, -(_e1190), (_e1144 < 0f)) / _e506.member_3) * 0.5f);
let _e1197 = select(-8e6f, _e1195, (_e1195 > -8e6f));
let _e1199 = select(8e6f, _e1197, (_e1197 < 8e6f));
let _e1206 = select(0i, select(select(i32(_e1199), i32(-2147483648), (_e1199 < -2147483600f)), 2147483647i, (_e1199 > 2147483500f)), (_e1199 == _e1199));
let _e1213 = ((_e1195 - f32((_e1206 - select(0i, 1i, (_e1199 < f32(_e1206)))))) * 2f);
let _e1221 = ((select(select((_e1213 - 2f), (1f - _e1213), (_e1213 < 1.5f)), _e1213, (_e1213 < 0.5f)) * 2f) / _e1051);
let _e1223 = select(-1f, _e1221, (_e1221 > -1f));
let _e1226 = (2f - _e1051);
let _e1228 = select(0f, _e1226, (_e1226 > 0f));
let _e1234 = (0.5f + ((0.5f * (select(1f, _e1132, (_e1132 < 1f)) * select(1f, _e1137, (_e1137 < 1f)))) * (select(1f, _e1223, (_e1223 < 1f)) * select(1f, _e1228, (_e1228 < 1f)))));
phi_3120_ = vec3<f32>((_e506.member + ((_e509.member - _e506.member) * _e1234)), (_e506.member_1 + ((_e509.member_1 - _e506.member_1) * _e1234)), (_e506.member_2 + ((_e509.member_2 - _e506.member_2) * _e1234)));
} else {
let _e1246 = bitcast<i32>(_e503.y);
let _e1250 = f32(bitcast<i32>(_e503.w));
let _e1252 = (2f * 3.1415927f);
let _e1253 = ((_e1006 * f32(_e1246)) / _e1252);
let _e1255 = select(1e-6f, _e1253, (_e1253 > 1e-6f));
let _e1258 = bitcast<u32>(select(1.1754944e-38f, _e1255, (_e1255 > 1.1754944e-38f)));
let _e1259 = (_e1258 & 8388607u);
let _e1261 = select(0u, 1u, (_e1259 > 3474675u));
let _e1272 = bitcast<f32>((_e1259 | ((127u - _e1261) << bitcast<u32>(23i))));
let _e1275 = ((_e1272 - 1f) / (_e1272 + 1f));
let _e1276 = (_e1275 * _e1275);
let _e1291 = (f32(((bitcast<i32>((_e1258 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e1261))) + (((2f * _e1275) + ((_e1275 * _e1276) * (0.6666667f + (_e1276 * (0.4f + (_e1276 * (0.2857143f + (_e1276 * (0.22222222f + (_e1276 * 0.18181819f)))))))))) * 1.442695f));
let _e1292 = (_e1250 - 1f);
let _e1294 = select(0f, _e1291, (_e1291 > 0f));
let _e1296 = select(_e1292, _e1294, (_e1294 < _e1292));
let _e1297 = (_e1250 - 2f);
let _e1299 = select(0f, _e1297, (_e1297 > 0f));
let _e1301 = select(0f, _e1296, (_e1296 > 0f));
let _e1303 = select(_e1299, _e1301, (_e1301 < _e1299));
let _e1310 = select(0i, select(select(i32(_e1303), i32(-2147483648), (_e1303 < -2147483600f)), 2147483647i, (_e1303 > 2147483500f)), (_e1303 == _e1303));
let _e1314 = (_e1310 - select(0i, 1i, (_e1303 < f32(_e1310))));
let _e1317 = bitcast<f32>((bitcast<u32>(_e582) & 2147483647u));
let _e1320 = bitcast<f32>((bitcast<u32>(_e571) & 2147483647u));
let _e1324 = select(_e1320, _e1317, (_e1317 > _e1320));
let _e1327 = (select(_e1320, _e1317, (_e1317 < _e1320)) / select(1.1754944e-38f, _e1324, (_e1324 > 1.1754944e-38f)));
let _e1328 = (_e1327 > 0.41421357f);
let _e1332 = select(_e1327, ((_e1327 - 1f) / (_e1327 + 1f)), _e1328);
let _e1333 = (_e1332 * _e1332);
let _e1348 = (select(0f, 0.7853982f, _e1328) + (_e1332 + ((_e1332 * _e1333) * (-0.33333334f + (_e1333 * (0.2f + (_e1333 * (-0.14285713f + (_e1333 * (0.11111111f + (_e1333 * (-0.09090909f + (_e1333 * 0.0585f)))))))))))));
let _e1351 = select(_e1348, (1.5707964f - _e1348), (_e1320 > _e1317));
let _e1354 = select(_e1351, (3.1415927f - _e1351), (_e582 < 0f));
let _e1359 = (0.5f - (select(_e1354, -(_e1354), (_e571 < 0f)) / _e1252));
let _e1361 = select(-1f, _e593, (_e593 > -1f));
let _e1363 = select(1f, _e1361, (_e1361 < 1f));
let _e1366 = ((1f - _e1363) * (1f + _e1363));
let _e1369 = sqrt(select(0f, _e1366, (_e1366 > 0f)));
let _e1372 = bitcast<f32>((bitcast<u32>(_e1369) & 2147483647u));
let _e1375 = bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u));
let _e1379 = select(_e1375, _e1372, (_e1372 > _e1375));
let _e1382 = (select(_e1375, _e1372, (_e1372 < _e1375)) / select(1.1754944e-38f, _e1379, (_e1379 > 1.1754944e-38f)));
let _e1383 = (_e1382 > 0.41421357f);
let _e1387 = select(_e1382, ((_e1382 - 1f) / (_e1382 + 1f)), _e1383);
let _e1388 = (_e1387 * _e1387);
let _e1403 = (select(0f, 0.7853982f, _e1383) + (_e1387 + ((_e1387 * _e1388) * (-0.33333334f + (_e1388 * (0.2f + (_e1388 * (-0.14285713f + (_e1388 * (0.11111111f + (_e1388 * (-0.09090909f + (_e1388 * 0.0585f)))))))))))));
let _e1406 = select(_e1403, (1.5707964f - _e1403), (_e1375 > _e1372));
let _e1409 = select(_e1406, (3.1415927f - _e1406), (_e1369 < 0f));
let _e1414 = (0.5f - (select(_e1409, -(_e1409), (_e1363 < 0f)) / 3.1415927f));
let _e1416 = bitcast<i32>(_e503.z);
phi_2342_ = 0i;
phi_2345_ = 0i;
phi_2347_ = _e1416;
phi_2349_ = _e1246;
loop {
let _e1418 = phi_2342_;
let _e1420 = phi_2345_;
let _e1422 = phi_2347_;
let _e1424 = phi_2349_;
local_12 = _e1424;
local_13 = _e1422;
local_14 = _e1424;
local_15 = _e1424;
local_16 = _e1424;
local_17 = _e1424;
local_18 = _e1424;
local_19 = _e1424;
local_20 = _e1422;
local_21 = _e1422;
local_22 = _e1422;
local_23 = _e1422;
local_24 = _e1424;
local_25 = _e1420;
local_26 = _e1424;
local_27 = _e1420;
let _e1425 = (_e1418 < _e1314);
if _e1425 {
if (_e1424 > 1i) {
phi_2364_ = (_e1424 >> bitcast<u32>(1i));
} else {
phi_2364_ = 1i;
}
let _e1432 = phi_2364_;
if (_e1422 > 1i) {
phi_2370_ = (_e1422 >> bitcast<u32>(1i));
} else {
phi_2370_ = 1i;
}
let _e1437 = phi_2370_;
phi_2343_ = (_e1418 + 1i);
phi_2346_ = (_e1420 + (_e1424 * _e1422));
phi_2348_ = _e1437;
phi_2350_ = _e1432;
} else {
phi_2343_ = i32();
phi_2346_ = i32();
phi_2348_ = i32();
phi_2350_ = i32();
}
let _e1440 = phi_2343_;
let _e1442 = phi_2346_;
let _e1444 = phi_2348_;
let _e1446 = phi_2350_;
continue;
continuing {
phi_2342_ = _e1440;
phi_2345_ = _e1442;
phi_2347_ = _e1444;
phi_2349_ = _e1446;
break if !(_e1425);
}
}
let _e1449 = local_12;
let _e1450 = f32(_e1449);
let _e1452 = ((_e1359 * _e1450) - 0.5f);
let _e1454 = local_13;
let _e1455 = f32(_e1454);
let _e1457 = ((_e1414 * _e1455) - 0.5f);
let _e1459 = select(-1f, _e1452, (_e1452 > -1f));
let _e1461 = select(_e1450, _e1459, (_e1459 < _e1450));
let _e1468 = select(0i, select(select(i32(_e1461), i32(-2147483648), (_e1461 < -2147483600f)), 2147483647i, (_e1461 > 2147483500f)), (_e1461 == _e1461));
let _e1472 = (_e1468 - select(0i, 1i, (_e1461 < f32(_e1468))));
let _e1474 = select(-1f, _e1457, (_e1457 > -1f));
let _e1476 = select(_e1455, _e1474, (_e1474 < _e1455));
let _e1483 = select(0i, select(select(i32(_e1476), i32(-2147483648), (_e1476 < -2147483600f)), 2147483647i, (_e1476 > 2147483500f)), (_e1476 == _e1476));
let _e1487 = (_e1483 - select(0i, 1i, (_e1476 < f32(_e1483))));
let _e1489 = (_e1452 - f32(_e1472));
let _e1491 = (_e1457 - f32(_e1487));
let _e1493 = select(0f, _e1491, (_e1491 > 0f));
let _e1495 = select(1f, _e1493, (_e1493 < 1f));
if (_e1472 < 0i) {
let _e1498 = local_14;
phi_2445_ = (_e1472 + _e1498);
} else {
phi_2445_ = _e1472;
}
let _e1501 = phi_2445_;
let _e1503 = local_15;
if (_e1501 >= _e1503) {
let _e1506 = local_16;
phi_2451_ = (_e1501 - _e1506);
} else {
phi_2451_ = _e1501;
}
let _e1509 = phi_2451_;
let _e1510 = (_e1472 + 1i);
if (_e1510 < 0i) {
let _e1513 = local_17;
phi_2458_ = (_e1510 + _e1513);
} else {
phi_2458_ = _e1510;
}
let _e1516 = phi_2458_;
let _e1518 = local_18;
if (_e1516 >= _e1518) {
let _e1521 = local_19;
phi_2464_ = (_e1516 - _e1521);
} else {
phi_2464_ = _e1516;
}
let _e1524 = phi_2464_;
let _e1526 = select(_e1487, 0i, (_e1487 < 0i));
let _e1528 = local_20;
if (_e1526 >= _e1528) {
let _e1531 = local_21;
phi_2475_ = (_e1531 - 1i);
} else {
phi_2475_ = _e1526;
}
let _e1534 = phi_2475_;
let _e1535 = (_e1487 + 1i);
let _e1537 = select(_e1535, 0i, (_e1535 < 0i));
let _e1539 = local_22;
if (_e1537 >= _e1539) {
let _e1542 = local_23;
phi_2487_ = (_e1542 - 1i);
} else {
phi_2487_ = _e1537;
}
let _e1545 = phi_2487_;
let _e1547 = local_24;
let _e1550 = local_25;
let _e1551 = (_e1550 + (_e1534 * _e1547));
let _e1553 = local_26;
let _e1556 = local_27;
let _e1557 = (_e1556 + (_e1545 * _e1553));
let _e1559 = (3i * (_e1551 + _e1509));
let _e1561 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e1563 = select(_e1561, _e1559, (_e1559 < _e1561));
let _e1569 = global_3.member[bitcast<u32>(select(0i, _e1563, (_e1563 > 0i)))];
let _e1570 = (_e1559 + 1i);
let _e1572 = select(_e1561, _e1570, (_e1570 < _e1561));
let _e1578 = global_3.member[bitcast<u32>(select(0i, _e1572, (_e1572 > 0i)))];
let _e1579 = (_e1559 + 2i);
let _e1581 = select(_e1561, _e1579, (_e1579 < _e1561));
let _e1587 = global_3.member[bitcast<u32>(select(0i, _e1581, (_e1581 > 0i)))];
let _e1589 = (3i * (_e1551 + _e1524));
let _e1591 = select(_e1561, _e1589, (_e1589 < _e1561));
let _e1597 = global_3.member[bitcast<u32>(select(0i, _e1591, (_e1591 > 0i)))];
let _e1598 = (_e1589 + 1i);
let _e1600 = select(_e1561, _e1598, (_e1598 < _e1561));
let _e1606 = global_3.member[bitcast<u32>(select(0i, _e1600, (_e1600 > 0i)))];
let _e1607 = (_e1589 + 2i);
let _e1609 = select(_e1561, _e1607, (_e1607 < _e1561));
let _e1615 = global_3.member[bitcast<u32>(select(0i, _e1609, (_e1609 > 0i)))];
let _e1617 = (3i * (_e1557 + _e1509));
let _e1619 = select(_e1561, _e1617, (_e1617 < _e1561));
let _e1625 = global_3.member[bitcast<u32>(select(0i, _e1619, (_e1619 > 0i)))];
let _e1626 = (_e1617 + 1i);
let _e1628 = select(_e1561, _e1626, (_e1626 < _e1561));
let _e1634 = global_3.member[bitcast<u32>(select(0i, _e1628, (_e1628 > 0i)))];
let _e1635 = (_e1617 + 2i);
let _e1637 = select(_e1561, _e1635, (_e1635 < _e1561));
let _e1643 = global_3.member[bitcast<u32>(select(0i, _e1637, (_e1637 > 0i)))];
let _e1645 = (3i * (_e1557 + _e1524));
let _e1647 = select(_e1561, _e1645, (_e1645 < _e1561));
let _e1653 = global_3.member[bitcast<u32>(select(0i, _e1647, (_e1647 > 0i)))];
let _e1654 = (_e1645 + 1i);
let _e1656 = select(_e1561, _e1654, (_e1654 < _e1561));
let _e1662 = global_3.member[bitcast<u32>(select(0i, _e1656, (_e1656 > 0i)))];
let _e1663 = (_e1645 + 2i);
let _e1665 = select(_e1561, _e1663, (_e1663 < _e1561));
let _e1671 = global_3.member[bitcast<u32>(select(0i, _e1665, (_e1665 > 0i)))];
let _e1678 = (_e1569 + ((_e1597 - _e1569) * _e1489));
let _e1679 = (_e1578 + ((_e1606 - _e1578) * _e1489));
let _e1680 = (_e1587 + ((_e1615 - _e1587) * _e1489));
let _e1696 = (_e1678 + (((_e1625 + ((_e1653 - _e1625) * _e1489)) - _e1678) * _e1495));
let _e1697 = (_e1679 + (((_e1634 + ((_e1662 - _e1634) * _e1489)) - _e1679) * _e1495));
let _e1698 = (_e1680 + (((_e1643 + ((_e1671 - _e1643) * _e1489)) - _e1680) * _e1495));
phi_2721_ = 0i;
phi_2724_ = 0i;
phi_2726_ = _e1416;
phi_2728_ = _e1246;
loop {
let _e1701 = phi_2721_;
let _e1703 = phi_2724_;
let _e1705 = phi_2726_;
let _e1707 = phi_2728_;
local_28 = _e1707;
local_29 = _e1705;
local_30 = _e1707;
local_31 = _e1707;
local_32 = _e1707;
local_33 = _e1707;
local_34 = _e1707;
local_35 = _e1707;
local_36 = _e1705;
local_37 = _e1705;
local_38 = _e1705;
local_39 = _e1705;
local_40 = _e1707;
local_41 = _e1703;
local_42 = _e1707;
local_43 = _e1703;
let _e1708 = (_e1701 < (_e1314 + 1i));
if _e1708 {
if (_e1707 > 1i) {
phi_2743_ = (_e1707 >> bitcast<u32>(1i));
} else {
phi_2743_ = 1i;
}
let _e1715 = phi_2743_;
if (_e1705 > 1i) {
phi_2749_ = (_e1705 >> bitcast<u32>(1i));
} else {
phi_2749_ = 1i;
}
let _e1720 = phi_2749_;
phi_2722_ = (_e1701 + 1i);
phi_2725_ = (_e1703 + (_e1707 * _e1705));
phi_2727_ = _e1720;
phi_2729_ = _e1715;
} else {
phi_2722_ = i32();
phi_2725_ = i32();
phi_2727_ = i32();
phi_2729_ = i32();
}
let _e1723 = phi_2722_;
let _e1725 = phi_2725_;
let _e1727 = phi_2727_;
let _e1729 = phi_2729_;
continue;
continuing {
phi_2721_ = _e1723;
phi_2724_ = _e1725;
phi_2726_ = _e1727;
phi_2728_ = _e1729;
break if !(_e1708);
}
}
let _e1732 = local_28;
let _e1733 = f32(_e1732);
let _e1735 = ((_e1359 * _e1733) - 0.5f);
let _e1737 = local_29;
let _e1738 = f32(_e1737);
let _e1740 = ((_e1414 * _e1738) - 0.5f);
let _e1742 = select(-1f, _e1735, (_e1735 > -1f));
let _e1744 = select(_e1733, _e1742, (_e1742 < _e1733));
let _e1751 = select(0i, select(select(i32(_e1744), i32(-2147483648), (_e1744 < -2147483600f)), 2147483647i, (_e1744 > 2147483500f)), (_e1744 == _e1744));
let _e1755 = (_e1751 - select(0i, 1i, (_e1744 < f32(_e1751))));
let _e1757 = select(-1f, _e1740, (_e1740 > -1f));
let _e1759 = select(_e1738, _e1757, (_e1757 < _e1738));
let _e1766 = select(0i, select(select(i32(_e1759), i32(-2147483648), (_e1759 < -2147483600f)), 2147483647i, (_e1759 > 2147483500f)), (_e1759 == _e1759));
let _e1770 = (_e1766 - select(0i, 1i, (_e1759 < f32(_e1766))));
let _e1772 = (_e1735 - f32(_e1755));
let _e1774 = (_e1740 - f32(_e1770));
let _e1776 = select(0f, _e1774, (_e1774 > 0f));
let _e1778 = select(1f, _e1776, (_e1776 < 1f));
if (_e1755 < 0i) {
let _e1781 = local_30;
phi_2824_ = (_e1755 + _e1781);
} else {
phi_2824_ = _e1755;
}
let _e1784 = phi_2824_;
let _e1786 = local_31;
if (_e1784 >= _e1786) {
let _e1789 = local_32;
phi_2830_ = (_e1784 - _e1789);
} else {
phi_2830_ = _e1784;
}
let _e1792 = phi_2830_;
let _e1793 = (_e1755 + 1i);
if (_e1793 < 0i) {
let _e1796 = local_33;
phi_2837_ = (_e1793 + _e1796);
} else {
phi_2837_ = _e1793;
}
let _e1799 = phi_2837_;
let _e1801 = local_34;
if (_e1799 >= _e1801) {
let _e1804 = local_35;
phi_2843_ = (_e1799 - _e1804);
} else {
phi_2843_ = _e1799;
}
let _e1807 = phi_2843_;
let _e1809 = select(_e1770, 0i, (_e1770 < 0i));
let _e1811 = local_36;
if (_e1809 >= _e1811) {
let _e1814 = local_37;
phi_2854_ = (_e1814 - 1i);
} else {
phi_2854_ = _e1809;
}
let _e1817 = phi_2854_;
let _e1818 = (_e1770 + 1i);
let _e1820 = select(_e1818, 0i, (_e1818 < 0i));
let _e1822 = local_38;
if (_e1820 >= _e1822) {
let _e1825 = local_39;
phi_2866_ = (_e1825 - 1i);
} else {
phi_2866_ = _e1820;
}
let _e1828 = phi_2866_;
let _e1830 = local_40;
let _e1833 = local_41;
let _e1834 = (_e1833 + (_e1817 * _e1830));
let _e1836 = local_42;
let _e1839 = local_43;
let _e1840 = (_e1839 + (_e1828 * _e1836));
let _e1842 = (3i * (_e1834 + _e1792));
let _e1844 = select(_e1561, _e1842, (_e1842 < _e1561));
let _e1850 = global_3.member[bitcast<u32>(select(0i, _e1844, (_e1844 > 0i)))];
let _e1851 = (_e1842 + 1i);
let _e1853 = select(_e1561, _e1851, (_e1851 < _e1561));
let _e1859 = global_3.member[bitcast<u32>(select(0i, _e1853, (_e1853 > 0i)))];
let _e1860 = (_e1842 + 2i);
let _e1862 = select(_e1561, _e1860, (_e1860 < _e1561));
let _e1868 = global_3.member[bitcast<u32>(select(0i, _e1862, (_e1862 > 0i)))];
let _e1870 = (3i * (_e1834 + _e1807));
let _e1872 = select(_e1561, _e1870, (_e1870 < _e1561));
let _e1878 = global_3.member[bitcast<u32>(select(0i, _e1872, (_e1872 > 0i)))];
let _e1879 = (_e1870 + 1i);
let _e1881 = select(_e1561, _e1879, (_e1879 < _e1561));
let _e1887 = global_3.member[bitcast<u32>(select(0i, _e1881, (_e1881 > 0i)))];
let _e1888 = (_e1870 + 2i);
let _e1890 = select(_e1561, _e1888, (_e1888 < _e1561));
let _e1896 = global_3.member[bitcast<u32>(select(0i, _e1890, (_e1890 > 0i)))];
let _e1898 = (3i * (_e1840 + _e1792));
let _e1900 = select(_e1561, _e1898, (_e1898 < _e1561));
let _e1906 = global_3.member[bitcast<u32>(select(0i, _e1900, (_e1900 > 0i)))];
let _e1907 = (_e1898 + 1i);
let _e1909 = select(_e1561, _e1907, (_e1907 < _e1561));
let _e1915 = global_3.member[bitcast<u32>(select(0i, _e1909, (_e1909 > 0i)))];
let _e1916 = (_e1898 + 2i);
let _e1918 = select(_e1561, _e1916, (_e1916 < _e1561));
let _e1924 = global_3.member[bitcast<u32>(select(0i, _e1918, (_e1918 > 0i)))];
let _e1926 = (3i * (_e1840 + _e1807));
let _e1928 = select(_e1561, _e1926, (_e1926 < _e1561));
let _e1934 = global_3.member[bitcast<u32>(select(0i, _e1928, (_e1928 > 0i)))];
let _e1935 = (_e1926 + 1i);
let _e1937 = select(_e1561, _e1935, (_e1935 < _e1561));
let _e1943 = global_3.member[bitcast<u32>(select(0i, _e1937, (_e1937 > 0i)))];
let _e1944 = (_e1926 + 2i);
let _e1946 = select(_e1561, _e1944, (_e1944 < _e1561));
let _e1952 = global_3.member[bitcast<u32>(select(0i, _e1946, (_e1946 > 0i)))];
let _e1959 = (_e1850 + ((_e1878 - _e1850) * _e1772));
let _e1960 = (_e1859 + ((_e1887 - _e1859) * _e1772));
let _e1961 = (_e1868 + ((_e1896 - _e1868) * _e1772));
let _e1984 = (_e1296 - f32(_e1314));
let _e1986 = select(0f, _e1984, (_e1984 > 0f));
let _e1988 = select(1f, _e1986, (_e1986 < 1f));
phi_3120_ = vec3<f32>(((_e1696 + (((_e1959 + (((_e1906 + ((_e1934 - _e1906) * _e1772)) - _e1959) * _e1778)) - _e1696) * _e1988)) * _e509.member_3), ((_e1697 + (((_e1960 + (((_e1915 + ((_e1943 - _e1915) * _e1772)) - _e1960) * _e1778)) - _e1697) * _e1988)) * _e509.member_3), ((_e1698 + (((_e1961 + (((_e1924 + ((_e1952 - _e1924) * _e1772)) - _e1961) * _e1778)) - _e1698) * _e1988)) * _e509.member_3));
}
let _e2001 = phi_3120_;
phi_3121_ = _e2001;
}
let _e2003 = phi_3121_;
phi_3122_ = _e2003;
}
let _e2005 = phi_3122_;
let _e2009 = global_1.member.member_31.member_3;
let _e2016 = (_e500 * _e2009);
let _e2028 = (1f - ((_e500 * ((_e235 + _e246) + _e257)) * (1f / 3f)));
global_4.member[_e122] = ((_e180 + ((_e235 * (select(_e410.member, _e407.member, _e399) * (((_e422.member * _e461) * _e467) + _e473.member))) * _e485)) + ((_e235 * _e2005.x) * _e2016));
global_4.member[(_e120 + _e122)] = ((_e191 + ((_e246 * (select(_e410.member_1, _e407.member_1, _e399) * (((_e422.member_1 * _e461) * _e467) + _e473.member_1))) * _e485)) + ((_e246 * _e2005.y) * _e2016));
global_4.member[((2u * _e120) + _e122)] = ((_e202 + ((_e257 * (select(_e410.member_2, _e407.member_2, _e399) * (((_e422.member_2 * _e461) * _e467) + _e473.member_2))) * _e485)) + ((_e257 * _e2005.z) * _e2016));
global_4.member[((3u * _e120) + _e122)] = (_e2028 + ((1f - _e2028) * _e2009));
global_4.member[((4u * _e120) + _e122)] = _e495;
global_4.member[((5u * _e120) + _e122)] = _e235;
global_4.member[((6u * _e120) + _e122)] = _e246;
global_4.member[((7u * _e120) + _e122)] = _e257;
global_4.member[((8u * _e120) + _e122)] = ((_e224 + (_e485 * (_e347 + (_e304 * select(_e371, _e395, _e399))))) / select(1e-12f, _e495, (_e495 > 1e-12f)));
global_4.member[((9u * _e120) + _e122)] = _e302;
global_4.member[((10u * _e120) + _e122)] = _e303;
global_4.member[((11u * _e120) + _e122)] = -(_e304);
global_4.member[((12u * _e120) + _e122)] = _e345;
global_4.member[((13u * _e120) + _e122)] = _e346;
global_4.member[((14u * _e120) + _e122)] = -(_e347);
global_4.member[((15u * _e120) + _e122)] = select(2f, _e169, (_e169 < 2f));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
