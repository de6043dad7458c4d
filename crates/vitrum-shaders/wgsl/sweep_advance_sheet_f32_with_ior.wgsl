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
struct type_11 {
member: array<f32>,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_21 {
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
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: type_24,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(5)
var<storage> global_5: type_11;
@group(0) @binding(6)
var<storage, read_write> global_6: type_11;
@group(0) @binding(2)
var<storage> global_7: type_16;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var local_6: type_28;
var local_7: vec3<f32>;
var phi_5591_: type_29;
var phi_6237_: type_30;
var phi_7106_: type_5;
var phi_8132_: vec3<f32>;
var phi_8133_: bool;
switch bitcast<i32>(0u) {
default: {
let _e88 = global;
let _e91 = arrayLength((&global_2.member));
let _e98 = arrayLength((&global_4.member));
let _e105 = global_1.member.member_2;
let _e108 = global_1.member.member;
let _e116 = (_e88.x + _e105.member);
let _e118 = (_e88.y + _e105.member_1);
if (_e116 < _e105.member_2) {
if (_e118 < _e105.member_3) {
let _e121 = (_e108.member * _e108.member_1);
let _e123 = ((_e118 * _e108.member) + _e116);
let _e124 = bitcast<i32>(_e123);
let _e126 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e128 = select(_e126, _e124, (_e124 < _e126));
let _e134 = global_6.member[bitcast<u32>(select(0i, _e128, (_e128 > 0i)))];
let _e135 = (_e121 + _e123);
let _e136 = bitcast<i32>(_e135);
let _e138 = select(_e126, _e136, (_e136 < _e126));
let _e144 = global_6.member[bitcast<u32>(select(0i, _e138, (_e138 > 0i)))];
let _e146 = ((2u * _e121) + _e123);
let _e147 = bitcast<i32>(_e146);
let _e149 = select(_e126, _e147, (_e147 < _e126));
let _e155 = global_6.member[bitcast<u32>(select(0i, _e149, (_e149 > 0i)))];
let _e157 = ((3u * _e121) + _e123);
let _e158 = bitcast<i32>(_e157);
let _e160 = select(_e126, _e158, (_e158 < _e126));
let _e166 = global_6.member[bitcast<u32>(select(0i, _e160, (_e160 > 0i)))];
let _e168 = ((4u * _e121) + _e123);
let _e169 = bitcast<i32>(_e168);
let _e171 = select(_e126, _e169, (_e169 < _e126));
let _e177 = global_6.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e179 = ((5u * _e121) + _e123);
let _e180 = bitcast<i32>(_e179);
let _e182 = select(_e126, _e180, (_e180 < _e126));
let _e188 = global_6.member[bitcast<u32>(select(0i, _e182, (_e182 > 0i)))];
let _e190 = ((6u * _e121) + _e123);
let _e191 = bitcast<i32>(_e190);
let _e193 = select(_e126, _e191, (_e191 < _e126));
let _e199 = global_6.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e201 = ((7u * _e121) + _e123);
let _e202 = bitcast<i32>(_e201);
let _e204 = select(_e126, _e202, (_e202 < _e126));
let _e210 = global_6.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e212 = ((8u * _e121) + _e123);
let _e213 = bitcast<i32>(_e212);
let _e215 = select(_e126, _e213, (_e213 < _e126));
let _e221 = global_6.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e223 = ((9u * _e121) + _e123);
let _e224 = bitcast<i32>(_e223);
let _e226 = select(_e126, _e224, (_e224 < _e126));
let _e232 = global_6.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e234 = ((10u * _e121) + _e123);
let _e235 = bitcast<i32>(_e234);
let _e237 = select(_e126, _e235, (_e235 < _e126));
let _e243 = global_6.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e248 = global_1.member.member_5.member_2;
let _e251 = (1f / select(1e-6f, _e199, (_e199 > 1e-6f)));
let _e255 = global_1.member.member_8.member_5;
let _e256 = (_e248 * _e255);
let _e261 = global_1.member.member_8.member_6;
let _e263 = (((_e177 * _e251) - _e261) * _e256);
let _e268 = global_1.member.member_8.member_7;
let _e270 = (((_e188 * _e251) - _e268) * _e256);
let _e274 = ((f32(bitcast<i32>(_e116)) - 0.5f) + _e134);
let _e278 = global_1.member.member_8.member_1;
let _e279 = (_e278 + 1u);
let _e281 = select(1u, _e279, (_e279 > 0u));
let _e282 = (_e281 == 0u);
if _e282 {
break;
}
let _e287 = ((f32(bitcast<i32>((_e118 % _e281))) - 0.5f) + _e144);
let _e291 = global_1.member.member_5.member;
let _e295 = global_1.member.member_8.member_8;
let _e296 = (_e291 - _e295);
let _e300 = global_1.member.member_8.member_2;
let _e307 = global_1.member.member_8.member_4;
let _e309 = ((_e300 + (_e261 * _e296)) + ((_e274 + 0.5f) * _e307));
let _e313 = global_1.member.member_8.member_3;
let _e318 = ((_e313 + (_e268 * _e296)) + ((_e287 + 0.5f) * _e307));
let _e324 = global_1.member.member_5.member_1;
let _e325 = (_e324 - _e295);
let _e330 = ((_e300 + (_e261 * _e325)) + (((_e274 + _e263) + 0.5f) * _e307));
let _e335 = ((_e313 + (_e268 * _e325)) + (((_e287 + _e270) + 0.5f) * _e307));
if _e282 {
break;
}
let _e338 = bitcast<i32>(((_e118 / _e281) * 3u));
let _e340 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e342 = select(_e340, _e338, (_e338 < _e340));
let _e348 = global_5.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
let _e349 = (_e338 + 1i);
let _e351 = select(_e340, _e349, (_e349 < _e340));
let _e357 = global_5.member[bitcast<u32>(select(0i, _e351, (_e351 > 0i)))];
let _e358 = (_e338 + 2i);
let _e360 = select(_e340, _e358, (_e358 < _e340));
let _e366 = global_5.member[bitcast<u32>(select(0i, _e360, (_e360 > 0i)))];
let _e369 = (1f / select(1e-6f, _e366, (_e366 > 1e-6f)));
let _e372 = (((_e348 * _e369) - _e261) * _e256);
let _e375 = (((_e357 * _e369) - _e268) * _e256);
let _e387 = global_1.member.member_6.member;
let _e398 = ((((_e387.member.member * _e309) + (_e387.member.member_1 * _e318)) + (_e387.member.member_2 * _e291)) + _e387.member_1);
let _e402 = global_1.member.member_6.member_1;
let _e413 = ((((_e402.member.member * _e309) + (_e402.member.member_1 * _e318)) + (_e402.member.member_2 * _e291)) + _e402.member_1);
let _e417 = global_1.member.member_6.member_2;
let _e428 = ((((_e417.member.member * _e309) + (_e417.member.member_1 * _e318)) + (_e417.member.member_2 * _e291)) + _e417.member_1);
let _e434 = ((((_e387.member.member * _e330) + (_e387.member.member_1 * _e335)) + (_e387.member.member_2 * _e324)) + _e387.member_1);
let _e440 = ((((_e402.member.member * _e330) + (_e402.member.member_1 * _e335)) + (_e402.member.member_2 * _e324)) + _e402.member_1);
let _e446 = ((((_e417.member.member * _e330) + (_e417.member.member_1 * _e335)) + (_e417.member.member_2 * _e324)) + _e417.member_1);
let _e450 = global_1.member.member_6.member_4;
let _e455 = global_1.member.member_6.member_3.member;
let _e456 = (_e455 - 0.5f);
let _e458 = select(-0.5f, _e434, (_e434 > -0.5f));
let _e460 = select(_e456, _e458, (_e458 < _e456));
let _e465 = global_1.member.member_6.member_3.member_1;
let _e466 = (_e465 - 0.5f);
let _e468 = select(-0.5f, _e440, (_e440 > -0.5f));
let _e470 = select(_e466, _e468, (_e468 < _e466));
let _e475 = global_1.member.member_6.member_3.member_2;
let _e476 = (_e475 - 0.5f);
let _e478 = select(-0.5f, _e446, (_e446 > -0.5f));
let _e480 = select(_e476, _e478, (_e478 < _e476));
let _e481 = (_e434 - _e398);
let _e482 = (_e440 - _e413);
let _e483 = (_e446 - _e428);
let _e486 = bitcast<f32>((bitcast<u32>(_e481) & 2147483647u));
let _e489 = bitcast<f32>((bitcast<u32>(_e482) & 2147483647u));
let _e491 = select(_e489, _e486, (_e486 > _e489));
let _e494 = bitcast<f32>((bitcast<u32>(_e483) & 2147483647u));
let _e503 = bitcast<f32>((bitcast<u32>((_e434 - _e460)) & 2147483647u));
let _e506 = bitcast<f32>((bitcast<u32>((_e440 - _e470)) & 2147483647u));
let _e508 = select(_e506, _e503, (_e503 > _e506));
let _e511 = bitcast<f32>((bitcast<u32>((_e446 - _e480)) & 2147483647u));
let _e515 = (_e460 + 0.5f);
let _e516 = (_e455 - 1f);
let _e518 = select(0f, _e515, (_e515 > 0f));
let _e520 = select(_e516, _e518, (_e518 < _e516));
let _e527 = select(0i, select(select(i32(_e520), i32(-2147483648), (_e520 < -2147483600f)), 2147483647i, (_e520 > 2147483500f)), (_e520 == _e520));
let _e535 = global_1.member.member_6.member_12;
let _e536 = (_e535 & 31u);
let _e539 = (_e470 + 0.5f);
let _e540 = (_e465 - 1f);
let _e542 = select(0f, _e539, (_e539 > 0f));
let _e544 = select(_e540, _e542, (_e542 < _e540));
let _e551 = select(0i, select(select(i32(_e544), i32(-2147483648), (_e544 < -2147483600f)), 2147483647i, (_e544 > 2147483500f)), (_e544 == _e544));
let _e558 = (_e480 + 0.5f);
let _e559 = (_e475 - 1f);
let _e561 = select(0f, _e558, (_e558 > 0f));
let _e563 = select(_e559, _e561, (_e561 < _e559));
let _e570 = select(0i, select(select(i32(_e563), i32(-2147483648), (_e563 < -2147483600f)), 2147483647i, (_e563 > 2147483500f)), (_e563 == _e563));
let _e581 = global_1.member.member_6.member_9.member;
let _e587 = global_1.member.member_6.member_9.member_1;
let _e592 = global_1.member.member_6.member_10;
let _e598 = ((bitcast<i32>(_e592) + ((_e527 - select(0i, 1i, (_e520 < f32(_e527)))) >> bitcast<u32>(_e536))) + (bitcast<i32>(_e581) * (((_e551 - select(0i, 1i, (_e544 < f32(_e551)))) >> bitcast<u32>(_e536)) + (bitcast<i32>(_e587) * ((_e570 - select(0i, 1i, (_e563 < f32(_e570)))) >> bitcast<u32>(_e536))))));
let _e600 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e602 = select(_e600, _e598, (_e598 < _e600));
let _e608 = global_3.member[bitcast<u32>(select(0i, _e602, (_e602 > 0i)))];
let _e615 = global_1.member.member_7.member;
let _e630 = global_1.member.member_7.member_1;
let _e645 = global_1.member.member_7.member_2;
let _e662 = ((((_e615.member.member * _e330) + (_e615.member.member_1 * _e335)) + (_e615.member.member_2 * _e324)) + _e615.member_1);
let _e668 = ((((_e630.member.member * _e330) + (_e630.member.member_1 * _e335)) + (_e630.member.member_2 * _e324)) + _e630.member_1);
let _e674 = ((((_e645.member.member * _e330) + (_e645.member.member_1 * _e335)) + (_e645.member.member_2 * _e324)) + _e645.member_1);
let _e678 = global_1.member.member_7.member_4;
let _e683 = global_1.member.member_7.member_3.member;
let _e684 = (_e683 - 0.5f);
let _e686 = select(-0.5f, _e662, (_e662 > -0.5f));
let _e688 = select(_e684, _e686, (_e686 < _e684));
let _e693 = global_1.member.member_7.member_3.member_1;
let _e694 = (_e693 - 0.5f);
let _e696 = select(-0.5f, _e668, (_e668 > -0.5f));
let _e698 = select(_e694, _e696, (_e696 < _e694));
let _e703 = global_1.member.member_7.member_3.member_2;
let _e704 = (_e703 - 0.5f);
let _e706 = select(-0.5f, _e674, (_e674 > -0.5f));
let _e708 = select(_e704, _e706, (_e706 < _e704));
let _e714 = bitcast<f32>((bitcast<u32>((_e662 - ((((_e615.member.member * _e309) + (_e615.member.member_1 * _e318)) + (_e615.member.member_2 * _e291)) + _e615.member_1))) & 2147483647u));
let _e717 = bitcast<f32>((bitcast<u32>((_e668 - ((((_e630.member.member * _e309) + (_e630.member.member_1 * _e318)) + (_e630.member.member_2 * _e291)) + _e630.member_1))) & 2147483647u));
let _e719 = select(_e717, _e714, (_e714 > _e717));
let _e722 = bitcast<f32>((bitcast<u32>((_e674 - ((((_e645.member.member * _e309) + (_e645.member.member_1 * _e318)) + (_e645.member.member_2 * _e291)) + _e645.member_1))) & 2147483647u));
let _e731 = bitcast<f32>((bitcast<u32>((_e662 - _e688)) & 2147483647u));
let _e734 = bitcast<f32>((bitcast<u32>((_e668 - _e698)) & 2147483647u));
let _e736 = select(_e734, _e731, (_e731 > _e734));
let _e739 = bitcast<f32>((bitcast<u32>((_e674 - _e708)) & 2147483647u));
let _e743 = (_e688 + 0.5f);
let _e744 = (_e683 - 1f);
let _e746 = select(0f, _e743, (_e743 > 0f));
let _e748 = select(_e744, _e746, (_e746 < _e744));
let _e755 = select(0i, select(select(i32(_e748), i32(-2147483648), (_e748 < -2147483600f)), 2147483647i, (_e748 > 2147483500f)), (_e748 == _e748));
let _e763 = global_1.member.member_7.member_12;
let _e764 = (_e763 & 31u);
let _e767 = (_e698 + 0.5f);
let _e768 = (_e693 - 1f);
let _e770 = select(0f, _e767, (_e767 > 0f));
let _e772 = select(_e768, _e770, (_e770 < _e768));
let _e779 = select(0i, select(select(i32(_e772), i32(-2147483648), (_e772 < -2147483600f)), 2147483647i, (_e772 > 2147483500f)), (_e772 == _e772));
let _e786 = (_e708 + 0.5f);
let _e787 = (_e703 - 1f);
let _e789 = select(0f, _e786, (_e786 > 0f));
let _e791 = select(_e787, _e789, (_e789 < _e787));
let _e798 = select(0i, select(select(i32(_e791), i32(-2147483648), (_e791 < -2147483600f)), 2147483647i, (_e791 > 2147483500f)), (_e791 == _e791));
let _e809 = global_1.member.member_7.member_9.member;
let _e815 = global_1.member.member_7.member_9.member_1;
let _e820 = global_1.member.member_7.member_10;
let _e826 = ((bitcast<i32>(_e820) + ((_e755 - select(0i, 1i, (_e748 < f32(_e755)))) >> bitcast<u32>(_e764))) + (bitcast<i32>(_e809) * (((_e779 - select(0i, 1i, (_e772 < f32(_e779)))) >> bitcast<u32>(_e764)) + (bitcast<i32>(_e815) * ((_e798 - select(0i, 1i, (_e791 < f32(_e798)))) >> bitcast<u32>(_e764))))));
let _e828 = select(_e600, _e826, (_e826 < _e600));
let _e834 = global_3.member[bitcast<u32>(select(0i, _e828, (_e828 > 0i)))];
let _e840 = global_1.member.member_1;
let _e847 = (((_e840 & 64u) != 0u) || ((((select(_e494, _e491, (_e491 > _e494)) <= _e450) && ((select(_e511, _e508, (_e508 > _e511)) > _e450) || (_e608 != 0u))) && ((select(_e722, _e719, (_e719 > _e722)) <= _e678) && ((select(_e739, _e736, (_e736 > _e739)) > _e678) || (_e834 != 0u)))) && ((_e840 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e263 == 0f) && (_e270 == 0f)) && (_e372 == 0f)) && (_e375 == 0f))), _e847), (_e243 == 0f)) > 1u) {
if _e282 {
break;
}
if _e282 {
break;
}
let _e854 = (_e108.member_2 == 2u);
let _e857 = (((_e108.member_2 == 1u) || _e854) || (_e108.member_2 == 5u));
if _e857 {
let _e859 = select(-1f, _e460, (_e460 > -1f));
let _e861 = select(_e455, _e859, (_e859 < _e455));
let _e868 = select(0i, select(select(i32(_e861), i32(-2147483648), (_e861 < -2147483600f)), 2147483647i, (_e861 > 2147483500f)), (_e861 == _e861));
let _e872 = (_e868 - select(0i, 1i, (_e861 < f32(_e868))));
let _e874 = select(-1f, _e470, (_e470 > -1f));
let _e876 = select(_e465, _e874, (_e874 < _e465));
let _e883 = select(0i, select(select(i32(_e876), i32(-2147483648), (_e876 < -2147483600f)), 2147483647i, (_e876 > 2147483500f)), (_e876 == _e876));
let _e887 = (_e883 - select(0i, 1i, (_e876 < f32(_e883))));
let _e889 = select(-1f, _e480, (_e480 > -1f));
let _e891 = select(_e475, _e889, (_e889 < _e475));
let _e898 = select(0i, select(select(i32(_e891), i32(-2147483648), (_e891 < -2147483600f)), 2147483647i, (_e891 > 2147483500f)), (_e891 == _e891));
let _e902 = (_e898 - select(0i, 1i, (_e891 < f32(_e898))));
let _e906 = global_1.member.member_6.member_7;
let _e910 = global_1.member.member_6.member_8;
let _e918 = (select(0i, select(select(i32(_e465), i32(-2147483648), (_e465 < -2147483600f)), 2147483647i, (_e465 > 2147483500f)), (_e465 == _e465)) - 1i);
let _e921 = (_e887 + 1i);
let _e931 = (select(0i, select(select(i32(_e475), i32(-2147483648), (_e475 < -2147483600f)), 2147483647i, (_e475 > 2147483500f)), (_e475 == _e475)) - 1i);
let _e934 = (_e902 + 1i);
let _e944 = (select(0i, select(select(i32(_e455), i32(-2147483648), (_e455 < -2147483600f)), 2147483647i, (_e455 > 2147483500f)), (_e455 == _e455)) - 1i);
let _e945 = (_e872 - 1i);
let _e950 = (_e872 + 1i);
let _e953 = (_e872 + 2i);
let _e956 = (select(0i, _e887, (_e887 > 0i)) * _e906);
let _e957 = (select(_e918, _e921, (_e921 < _e918)) * _e906);
let _e958 = (select(0i, _e902, (_e902 > 0i)) * _e910);
let _e959 = (select(_e931, _e934, (_e934 < _e931)) * _e910);
local_6 = type_28(array<i32, 4>(select(0i, _e945, (_e945 > 0i)), select(0i, _e872, (_e872 > 0i)), select(_e944, _e950, (_e950 < _e944)), select(_e944, _e953, (_e953 < _e944))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_7 = vec3<f32>((_e460 - f32(_e872)), (_e470 - f32(_e887)), (_e480 - f32(_e902)));
let _e970 = (_e958 + _e956);
let _e972 = (bitcast<i32>(_e91) - 1i);
let _e975 = local_6.member[1u];
let _e976 = (_e970 + _e975);
let _e978 = select(_e972, _e976, (_e976 < _e972));
let _e983 = global_2.member[bitcast<u32>(select(0i, _e978, (_e978 > 0i)))];
let _e984 = bitcast<f32>(_e983);
let _e987 = local_6.member[2u];
let _e988 = (_e970 + _e987);
let _e990 = select(_e972, _e988, (_e988 < _e972));
let _e995 = global_2.member[bitcast<u32>(select(0i, _e990, (_e990 > 0i)))];
let _e997 = local_7[0u];
let _e1000 = (_e984 + ((bitcast<f32>(_e995) - _e984) * _e997));
let _e1001 = (_e958 + _e957);
let _e1002 = local_6.member[1u];
let _e1003 = (_e1001 + _e1002);
let _e1005 = select(_e972, _e1003, (_e1003 < _e972));
let _e1010 = global_2.member[bitcast<u32>(select(0i, _e1005, (_e1005 > 0i)))];
let _e1011 = bitcast<f32>(_e1010);
let _e1012 = local_6.member[2u];
let _e1013 = (_e1001 + _e1012);
let _e1015 = select(_e972, _e1013, (_e1013 < _e972));
let _e1020 = global_2.member[bitcast<u32>(select(0i, _e1015, (_e1015 > 0i)))];
let _e1022 = local_7[0u];
let _e1026 = (_e959 + _e956);
let _e1027 = local_6.member[1u];
let _e1028 = (_e1026 + _e1027);
let _e1030 = select(_e972, _e1028, (_e1028 < _e972));
let _e1035 = global_2.member[bitcast<u32>(select(0i, _e1030, (_e1030 > 0i)))];
let _e1036 = bitcast<f32>(_e1035);
let _e1037 = local_6.member[2u];
let _e1038 = (_e1026 + _e1037);
let _e1040 = select(_e972, _e1038, (_e1038 < _e972));
let _e1045 = global_2.member[bitcast<u32>(select(0i, _e1040, (_e1040 > 0i)))];
let _e1047 = local_7[0u];
let _e1050 = (_e1036 + ((bitcast<f32>(_e1045) - _e1036) * _e1047));
let _e1051 = (_e959 + _e957);
let _e1052 = local_6.member[1u];
let _e1053 = (_e1051 + _e1052);
let _e1055 = select(_e972, _e1053, (_e1053 < _e972));
let _e1060 = global_2.member[bitcast<u32>(select(0i, _e1055, (_e1055 > 0i)))];
let _e1061 = bitcast<f32>(_e1060);
let _e1062 = local_6.member[2u];
let _e1063 = (_e1051 + _e1062);
let _e1065 = select(_e972, _e1063, (_e1063 < _e972));
let _e1070 = global_2.member[bitcast<u32>(select(0i, _e1065, (_e1065 > 0i)))];
let _e1072 = local_7[0u];
let _e1077 = local_7[1u];
let _e1080 = (_e1000 + (((_e1011 + ((bitcast<f32>(_e1020) - _e1011) * _e1022)) - _e1000) * _e1077));
let _e1081 = local_7[1u];
let _e1086 = local_7[2u];
let _e1093 = global_1.member.member_6.member_5;
let _e1098 = global_1.member.member_6.member_6;
let _e1099 = (((_e1080 + (((_e1050 + (((_e1061 + ((bitcast<f32>(_e1070) - _e1061) * _e1072)) - _e1050) * _e1081)) - _e1080) * _e1086)) * _e1093) + _e1098);
let _e1101 = select(0f, _e1099, (_e1099 > 0f));
let _e1105 = select(-1f, _e688, (_e688 > -1f));
let _e1107 = select(_e683, _e1105, (_e1105 < _e683));
let _e1114 = select(0i, select(select(i32(_e1107), i32(-2147483648), (_e1107 < -2147483600f)), 2147483647i, (_e1107 > 2147483500f)), (_e1107 == _e1107));
let _e1118 = (_e1114 - select(0i, 1i, (_e1107 < f32(_e1114))));
let _e1120 = select(-1f, _e698, (_e698 > -1f));
let _e1122 = select(_e693, _e1120, (_e1120 < _e693));
let _e1129 = select(0i, select(select(i32(_e1122), i32(-2147483648), (_e1122 < -2147483600f)), 2147483647i, (_e1122 > 2147483500f)), (_e1122 == _e1122));
let _e1133 = (_e1129 - select(0i, 1i, (_e1122 < f32(_e1129))));
let _e1135 = select(-1f, _e708, (_e708 > -1f));
let _e1137 = select(_e703, _e1135, (_e1135 < _e703));
let _e1144 = select(0i, select(select(i32(_e1137), i32(-2147483648), (_e1137 < -2147483600f)), 2147483647i, (_e1137 > 2147483500f)), (_e1137 == _e1137));
let _e1148 = (_e1144 - select(0i, 1i, (_e1137 < f32(_e1144))));
let _e1152 = global_1.member.member_7.member_7;
let _e1156 = global_1.member.member_7.member_8;
let _e1164 = (select(0i, select(select(i32(_e693), i32(-2147483648), (_e693 < -2147483600f)), 2147483647i, (_e693 > 2147483500f)), (_e693 == _e693)) - 1i);
let _e1165 = (_e1133 - 1i);
let _e1170 = (_e1133 + 1i);
let _e1173 = (_e1133 + 2i);
let _e1183 = (select(0i, select(select(i32(_e703), i32(-2147483648), (_e703 < -2147483600f)), 2147483647i, (_e703 > 2147483500f)), (_e703 == _e703)) - 1i);
let _e1184 = (_e1148 - 1i);
let _e1189 = (_e1148 + 1i);
let _e1192 = (_e1148 + 2i);
let _e1202 = (select(0i, select(select(i32(_e683), i32(-2147483648), (_e683 < -2147483600f)), 2147483647i, (_e683 > 2147483500f)), (_e683 == _e683)) - 1i);
let _e1203 = (_e1118 - 1i);
let _e1208 = (_e1118 + 1i);
let _e1211 = (_e1118 + 2i);
let _e1214 = (select(0i, _e1165, (_e1165 > 0i)) * _e1152);
let _e1215 = (select(0i, _e1133, (_e1133 > 0i)) * _e1152);
let _e1216 = (select(_e1164, _e1170, (_e1170 < _e1164)) * _e1152);
let _e1217 = (select(_e1164, _e1173, (_e1173 < _e1164)) * _e1152);
let _e1218 = (select(0i, _e1184, (_e1184 > 0i)) * _e1156);
let _e1219 = (select(0i, _e1148, (_e1148 > 0i)) * _e1156);
let _e1220 = (select(_e1183, _e1189, (_e1189 < _e1183)) * _e1156);
let _e1221 = (select(_e1183, _e1192, (_e1192 < _e1183)) * _e1156);
local_4 = type_28(array<i32, 4>(select(0i, _e1203, (_e1203 > 0i)), select(0i, _e1118, (_e1118 > 0i)), select(_e1202, _e1208, (_e1208 < _e1202)), select(_e1202, _e1211, (_e1211 < _e1202))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e688 - f32(_e1118)), (_e698 - f32(_e1133)), (_e708 - f32(_e1148)));
let _e1232 = (_e1219 + _e1215);
let _e1235 = local_4.member[0u];
let _e1236 = (_e1232 + _e1235);
let _e1238 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1240 = select(_e1238, _e1236, (_e1236 < _e1238));
let _e1245 = global_7.member[bitcast<u32>(select(0i, _e1240, (_e1240 > 0i)))];
let _e1246 = bitcast<f32>(_e1245);
let _e1249 = local_4.member[1u];
let _e1250 = (_e1232 + _e1249);
let _e1252 = select(_e1238, _e1250, (_e1250 < _e1238));
let _e1257 = global_7.member[bitcast<u32>(select(0i, _e1252, (_e1252 > 0i)))];
let _e1258 = bitcast<f32>(_e1257);
let _e1261 = local_4.member[2u];
let _e1262 = (_e1232 + _e1261);
let _e1264 = select(_e1238, _e1262, (_e1262 < _e1238));
let _e1269 = global_7.member[bitcast<u32>(select(0i, _e1264, (_e1264 > 0i)))];
let _e1270 = bitcast<f32>(_e1269);
let _e1273 = local_4.member[3u];
let _e1274 = (_e1232 + _e1273);
let _e1276 = select(_e1238, _e1274, (_e1274 < _e1238));
let _e1281 = global_7.member[bitcast<u32>(select(0i, _e1276, (_e1276 > 0i)))];
let _e1283 = local_5[0u];
let _e1286 = (_e1246 + ((_e1258 - _e1246) * _e1283));
let _e1287 = local_5[0u];
let _e1290 = (_e1258 + ((_e1270 - _e1258) * _e1287));
let _e1291 = local_5[0u];
let _e1294 = (_e1270 + ((bitcast<f32>(_e1281) - _e1270) * _e1291));
let _e1295 = (_e1219 + _e1216);
let _e1296 = local_4.member[0u];
let _e1297 = (_e1295 + _e1296);
let _e1299 = select(_e1238, _e1297, (_e1297 < _e1238));
let _e1304 = global_7.member[bitcast<u32>(select(0i, _e1299, (_e1299 > 0i)))];
let _e1305 = bitcast<f32>(_e1304);
let _e1306 = local_4.member[1u];
let _e1307 = (_e1295 + _e1306);
let _e1309 = select(_e1238, _e1307, (_e1307 < _e1238));
let _e1314 = global_7.member[bitcast<u32>(select(0i, _e1309, (_e1309 > 0i)))];
let _e1315 = bitcast<f32>(_e1314);
let _e1316 = local_4.member[2u];
let _e1317 = (_e1295 + _e1316);
let _e1319 = select(_e1238, _e1317, (_e1317 < _e1238));
let _e1324 = global_7.member[bitcast<u32>(select(0i, _e1319, (_e1319 > 0i)))];
let _e1325 = bitcast<f32>(_e1324);
let _e1326 = local_4.member[3u];
let _e1327 = (_e1295 + _e1326);
let _e1329 = select(_e1238, _e1327, (_e1327 < _e1238));
let _e1334 = global_7.member[bitcast<u32>(select(0i, _e1329, (_e1329 > 0i)))];
let _e1336 = local_5[0u];
let _e1340 = local_5[0u];
let _e1343 = (_e1315 + ((_e1325 - _e1315) * _e1340));
let _e1344 = local_5[0u];
let _e1348 = (_e1220 + _e1215);
let _e1349 = local_4.member[0u];
let _e1350 = (_e1348 + _e1349);
let _e1352 = select(_e1238, _e1350, (_e1350 < _e1238));
let _e1357 = global_7.member[bitcast<u32>(select(0i, _e1352, (_e1352 > 0i)))];
let _e1358 = bitcast<f32>(_e1357);
let _e1359 = local_4.member[1u];
let _e1360 = (_e1348 + _e1359);
let _e1362 = select(_e1238, _e1360, (_e1360 < _e1238));
let _e1367 = global_7.member[bitcast<u32>(select(0i, _e1362, (_e1362 > 0i)))];
let _e1368 = bitcast<f32>(_e1367);
let _e1369 = local_4.member[2u];
let _e1370 = (_e1348 + _e1369);
let _e1372 = select(_e1238, _e1370, (_e1370 < _e1238));
let _e1377 = global_7.member[bitcast<u32>(select(0i, _e1372, (_e1372 > 0i)))];
let _e1378 = bitcast<f32>(_e1377);
let _e1379 = local_4.member[3u];
let _e1380 = (_e1348 + _e1379);
let _e1382 = select(_e1238, _e1380, (_e1380 < _e1238));
let _e1387 = global_7.member[bitcast<u32>(select(0i, _e1382, (_e1382 > 0i)))];
let _e1389 = local_5[0u];
let _e1392 = (_e1358 + ((_e1368 - _e1358) * _e1389));
let _e1393 = local_5[0u];
let _e1396 = (_e1368 + ((_e1378 - _e1368) * _e1393));
let _e1397 = local_5[0u];
let _e1400 = (_e1378 + ((bitcast<f32>(_e1387) - _e1378) * _e1397));
let _e1401 = (_e1220 + _e1216);
let _e1402 = local_4.member[0u];
let _e1403 = (_e1401 + _e1402);
let _e1405 = select(_e1238, _e1403, (_e1403 < _e1238));
let _e1410 = global_7.member[bitcast<u32>(select(0i, _e1405, (_e1405 > 0i)))];
let _e1411 = bitcast<f32>(_e1410);
let _e1412 = local_4.member[1u];
let _e1413 = (_e1401 + _e1412);
let _e1415 = select(_e1238, _e1413, (_e1413 < _e1238));
let _e1420 = global_7.member[bitcast<u32>(select(0i, _e1415, (_e1415 > 0i)))];
let _e1421 = bitcast<f32>(_e1420);
let _e1422 = local_4.member[2u];
let _e1423 = (_e1401 + _e1422);
let _e1425 = select(_e1238, _e1423, (_e1423 < _e1238));
let _e1430 = global_7.member[bitcast<u32>(select(0i, _e1425, (_e1425 > 0i)))];
let _e1431 = bitcast<f32>(_e1430);
let _e1432 = local_4.member[3u];
let _e1433 = (_e1401 + _e1432);
let _e1435 = select(_e1238, _e1433, (_e1433 < _e1238));
let _e1440 = global_7.member[bitcast<u32>(select(0i, _e1435, (_e1435 > 0i)))];
let _e1442 = local_5[0u];
let _e1446 = local_5[0u];
let _e1449 = (_e1421 + ((_e1431 - _e1421) * _e1446));
let _e1450 = local_5[0u];
let _e1454 = (_e1219 + _e1214);
let _e1455 = local_4.member[1u];
let _e1456 = (_e1454 + _e1455);
let _e1458 = select(_e1238, _e1456, (_e1456 < _e1238));
let _e1463 = global_7.member[bitcast<u32>(select(0i, _e1458, (_e1458 > 0i)))];
let _e1464 = bitcast<f32>(_e1463);
let _e1465 = local_4.member[2u];
let _e1466 = (_e1454 + _e1465);
let _e1468 = select(_e1238, _e1466, (_e1466 < _e1238));
let _e1473 = global_7.member[bitcast<u32>(select(0i, _e1468, (_e1468 > 0i)))];
let _e1475 = local_5[0u];
let _e1478 = (_e1464 + ((bitcast<f32>(_e1473) - _e1464) * _e1475));
let _e1479 = (_e1219 + _e1217);
let _e1480 = local_4.member[1u];
let _e1481 = (_e1479 + _e1480);
let _e1483 = select(_e1238, _e1481, (_e1481 < _e1238));
let _e1488 = global_7.member[bitcast<u32>(select(0i, _e1483, (_e1483 > 0i)))];
let _e1489 = bitcast<f32>(_e1488);
let _e1490 = local_4.member[2u];
let _e1491 = (_e1479 + _e1490);
let _e1493 = select(_e1238, _e1491, (_e1491 < _e1238));
let _e1498 = global_7.member[bitcast<u32>(select(0i, _e1493, (_e1493 > 0i)))];
let _e1500 = local_5[0u];
let _e1504 = (_e1220 + _e1214);
let _e1505 = local_4.member[1u];
let _e1506 = (_e1504 + _e1505);
let _e1508 = select(_e1238, _e1506, (_e1506 < _e1238));
let _e1513 = global_7.member[bitcast<u32>(select(0i, _e1508, (_e1508 > 0i)))];
let _e1514 = bitcast<f32>(_e1513);
let _e1515 = local_4.member[2u];
let _e1516 = (_e1504 + _e1515);
let _e1518 = select(_e1238, _e1516, (_e1516 < _e1238));
let _e1523 = global_7.member[bitcast<u32>(select(0i, _e1518, (_e1518 > 0i)))];
let _e1525 = local_5[0u];
let _e1528 = (_e1514 + ((bitcast<f32>(_e1523) - _e1514) * _e1525));
let _e1529 = (_e1220 + _e1217);
let _e1530 = local_4.member[1u];
let _e1531 = (_e1529 + _e1530);
let _e1533 = select(_e1238, _e1531, (_e1531 < _e1238));
let _e1538 = global_7.member[bitcast<u32>(select(0i, _e1533, (_e1533 > 0i)))];
let _e1539 = bitcast<f32>(_e1538);
let _e1540 = local_4.member[2u];
let _e1541 = (_e1529 + _e1540);
let _e1543 = select(_e1238, _e1541, (_e1541 < _e1238));
let _e1548 = global_7.member[bitcast<u32>(select(0i, _e1543, (_e1543 > 0i)))];
let _e1550 = local_5[0u];
let _e1554 = (_e1218 + _e1215);
let _e1555 = local_4.member[1u];
let _e1556 = (_e1554 + _e1555);
let _e1558 = select(_e1238, _e1556, (_e1556 < _e1238));
let _e1563 = global_7.member[bitcast<u32>(select(0i, _e1558, (_e1558 > 0i)))];
let _e1564 = bitcast<f32>(_e1563);
let _e1565 = local_4.member[2u];
let _e1566 = (_e1554 + _e1565);
let _e1568 = select(_e1238, _e1566, (_e1566 < _e1238));
let _e1573 = global_7.member[bitcast<u32>(select(0i, _e1568, (_e1568 > 0i)))];
let _e1575 = local_5[0u];
let _e1578 = (_e1564 + ((bitcast<f32>(_e1573) - _e1564) * _e1575));
let _e1579 = (_e1221 + _e1215);
let _e1580 = local_4.member[1u];
let _e1581 = (_e1579 + _e1580);
let _e1583 = select(_e1238, _e1581, (_e1581 < _e1238));
let _e1588 = global_7.member[bitcast<u32>(select(0i, _e1583, (_e1583 > 0i)))];
let _e1589 = bitcast<f32>(_e1588);
let _e1590 = local_4.member[2u];
let _e1591 = (_e1579 + _e1590);
let _e1593 = select(_e1238, _e1591, (_e1591 < _e1238));
let _e1598 = global_7.member[bitcast<u32>(select(0i, _e1593, (_e1593 > 0i)))];
let _e1600 = local_5[0u];
let _e1603 = (_e1589 + ((bitcast<f32>(_e1598) - _e1589) * _e1600));
let _e1604 = (_e1218 + _e1216);
let _e1605 = local_4.member[1u];
let _e1606 = (_e1604 + _e1605);
let _e1608 = select(_e1238, _e1606, (_e1606 < _e1238));
let _e1613 = global_7.member[bitcast<u32>(select(0i, _e1608, (_e1608 > 0i)))];
let _e1614 = bitcast<f32>(_e1613);
let _e1615 = local_4.member[2u];
let _e1616 = (_e1604 + _e1615);
let _e1618 = select(_e1238, _e1616, (_e1616 < _e1238));
let _e1623 = global_7.member[bitcast<u32>(select(0i, _e1618, (_e1618 > 0i)))];
let _e1625 = local_5[0u];
let _e1629 = (_e1221 + _e1216);
let _e1630 = local_4.member[1u];
let _e1631 = (_e1629 + _e1630);
let _e1633 = select(_e1238, _e1631, (_e1631 < _e1238));
let _e1638 = global_7.member[bitcast<u32>(select(0i, _e1633, (_e1633 > 0i)))];
let _e1639 = bitcast<f32>(_e1638);
let _e1640 = local_4.member[2u];
let _e1641 = (_e1629 + _e1640);
let _e1643 = select(_e1238, _e1641, (_e1641 < _e1238));
let _e1648 = global_7.member[bitcast<u32>(select(0i, _e1643, (_e1643 > 0i)))];
let _e1650 = local_5[0u];
let _e1655 = local_5[1u];
let _e1658 = (_e1290 + ((_e1343 - _e1290) * _e1655));
let _e1659 = local_5[1u];
let _e1662 = (_e1396 + ((_e1449 - _e1396) * _e1659));
let _e1663 = local_5[1u];
let _e1666 = (_e1286 + (((_e1305 + ((_e1315 - _e1305) * _e1336)) - _e1286) * _e1663));
let _e1667 = local_5[1u];
let _e1672 = local_5[2u];
let _e1676 = local_5[1u];
let _e1679 = (_e1294 + (((_e1325 + ((bitcast<f32>(_e1334) - _e1325) * _e1344)) - _e1294) * _e1676));
let _e1680 = local_5[1u];
let _e1684 = local_5[2u];
let _e1688 = local_5[1u];
let _e1691 = (_e1478 + ((_e1290 - _e1478) * _e1688));
let _e1692 = local_5[1u];
let _e1696 = local_5[2u];
let _e1700 = local_5[1u];
let _e1703 = (_e1343 + (((_e1489 + ((bitcast<f32>(_e1498) - _e1489) * _e1500)) - _e1343) * _e1700));
let _e1704 = local_5[1u];
let _e1708 = local_5[2u];
let _e1712 = local_5[1u];
let _e1715 = (_e1578 + (((_e1614 + ((bitcast<f32>(_e1623) - _e1614) * _e1625)) - _e1578) * _e1712));
let _e1716 = local_5[2u];
let _e1720 = local_5[1u];
let _e1724 = local_5[2u];
let _e1728 = local_5[2u];
let _e1735 = global_1.member.member_7.member_5;
let _e1740 = global_1.member.member_7.member_6;
let _e1741 = (((_e1658 + ((_e1662 - _e1658) * _e1728)) * _e1735) + _e1740);
let _e1743 = select(0f, _e1741, (_e1741 > 0f));
let _e1747 = (((_e1666 + (((_e1392 + (((_e1411 + ((_e1421 - _e1411) * _e1442)) - _e1392) * _e1667)) - _e1666) * _e1672)) * _e1735) + _e1740);
let _e1749 = select(0f, _e1747, (_e1747 > 0f));
let _e1751 = select(1f, _e1749, (_e1749 < 1f));
let _e1753 = (((_e1679 + (((_e1400 + (((_e1431 + ((bitcast<f32>(_e1440) - _e1431) * _e1450)) - _e1400) * _e1680)) - _e1679) * _e1684)) * _e1735) + _e1740);
let _e1755 = select(0f, _e1753, (_e1753 > 0f));
let _e1757 = select(1f, _e1755, (_e1755 < 1f));
let _e1759 = (((_e1691 + (((_e1528 + ((_e1396 - _e1528) * _e1692)) - _e1691) * _e1696)) * _e1735) + _e1740);
let _e1761 = select(0f, _e1759, (_e1759 > 0f));
let _e1763 = select(1f, _e1761, (_e1761 < 1f));
let _e1765 = (((_e1703 + (((_e1449 + (((_e1539 + ((bitcast<f32>(_e1548) - _e1539) * _e1550)) - _e1449) * _e1704)) - _e1703) * _e1708)) * _e1735) + _e1740);
let _e1767 = select(0f, _e1765, (_e1765 > 0f));
let _e1769 = select(1f, _e1767, (_e1767 < 1f));
let _e1771 = (((_e1715 + ((_e1658 - _e1715) * _e1716)) * _e1735) + _e1740);
let _e1773 = select(0f, _e1771, (_e1771 > 0f));
let _e1775 = select(1f, _e1773, (_e1773 < 1f));
let _e1777 = (((_e1662 + (((_e1603 + (((_e1639 + ((bitcast<f32>(_e1648) - _e1639) * _e1650)) - _e1603) * _e1720)) - _e1662) * _e1724)) * _e1735) + _e1740);
let _e1779 = select(0f, _e1777, (_e1777 > 0f));
let _e1781 = select(1f, _e1779, (_e1779 < 1f));
let _e1782 = (select(1f, _e1743, (_e1743 < 1f)) * 1024f);
let _e1783 = (1024f - 1f);
let _e1785 = select(0f, _e1782, (_e1782 > 0f));
let _e1787 = select(_e1783, _e1785, (_e1785 < _e1783));
let _e1794 = select(0i, select(select(i32(_e1787), i32(-2147483648), (_e1787 < -2147483600f)), 2147483647i, (_e1787 > 2147483500f)), (_e1787 == _e1787));
let _e1798 = (_e1794 - select(0i, 1i, (_e1787 < f32(_e1794))));
let _e1799 = (262147i + _e1798);
let _e1801 = (bitcast<i32>(_e98) - 1i);
let _e1803 = select(_e1801, _e1799, (_e1799 < _e1801));
let _e1809 = global_4.member[bitcast<u32>(select(0i, _e1803, (_e1803 > 0i)))];
let _e1819 = select(_e1801, 262146i, (262146i < _e1801));
let _e1825 = global_4.member[bitcast<u32>(select(0i, _e1819, (_e1819 > 0i)))];
let _e1826 = bitcast<f32>(_e1825);
let _e1827 = (f32((bitcast<i32>((_e1809 & 4095u)) - 2048i)) * _e1826);
let _e1829 = select(_e1801, 262144i, (262144i < _e1801));
let _e1835 = global_4.member[bitcast<u32>(select(0i, _e1829, (_e1829 > 0i)))];
let _e1836 = bitcast<f32>(_e1835);
let _e1838 = select(_e1801, 262145i, (262145i < _e1801));
let _e1844 = global_4.member[bitcast<u32>(select(0i, _e1838, (_e1838 > 0i)))];
let _e1845 = bitcast<f32>(_e1844);
let _e1851 = ((_e1836 + (f32(bitcast<i32>((_e1809 >> bitcast<u32>(12u)))) * _e1845)) + (_e1827 * (_e1782 - f32(_e1798))));
let _e1852 = (_e1827 * 1024f);
if _e854 {
let _e1859 = ((0.5f * (_e1757 - _e1751)) * _e1852);
let _e1860 = ((0.5f * (_e1769 - _e1763)) * _e1852);
let _e1861 = ((0.5f * (_e1781 - _e1775)) * _e1852);
phi_5591_ = type_29(_e1851, vec3<f32>(_e1859, _e1860, _e1861), vec3<f32>((_e1859 * _e1851), (_e1860 * _e1851), (_e1861 * _e1851)));
} else {
let _e1868 = (_e1751 * 1024f);
let _e1870 = select(0f, _e1868, (_e1868 > 0f));
let _e1872 = select(_e1783, _e1870, (_e1870 < _e1783));
let _e1879 = select(0i, select(select(i32(_e1872), i32(-2147483648), (_e1872 < -2147483600f)), 2147483647i, (_e1872 > 2147483500f)), (_e1872 == _e1872));
let _e1883 = (_e1879 - select(0i, 1i, (_e1872 < f32(_e1879))));
let _e1884 = (262147i + _e1883);
let _e1886 = select(_e1801, _e1884, (_e1884 < _e1801));
let _e1892 = global_4.member[bitcast<u32>(select(0i, _e1886, (_e1886 > 0i)))];
let _e1907 = ((_e1836 + (f32(bitcast<i32>((_e1892 >> bitcast<u32>(12u)))) * _e1845)) + ((f32((bitcast<i32>((_e1892 & 4095u)) - 2048i)) * _e1826) * (_e1868 - f32(_e1883))));
let _e1908 = (_e1757 * 1024f);
let _e1910 = select(0f, _e1908, (_e1908 > 0f));
let _e1912 = select(_e1783, _e1910, (_e1910 < _e1783));
let _e1919 = select(0i, select(select(i32(_e1912), i32(-2147483648), (_e1912 < -2147483600f)), 2147483647i, (_e1912 > 2147483500f)), (_e1912 == _e1912));
let _e1923 = (_e1919 - select(0i, 1i, (_e1912 < f32(_e1919))));
let _e1924 = (262147i + _e1923);
let _e1926 = select(_e1801, _e1924, (_e1924 < _e1801));
let _e1932 = global_4.member[bitcast<u32>(select(0i, _e1926, (_e1926 > 0i)))];
let _e1947 = ((_e1836 + (f32(bitcast<i32>((_e1932 >> bitcast<u32>(12u)))) * _e1845)) + ((f32((bitcast<i32>((_e1932 & 4095u)) - 2048i)) * _e1826) * (_e1908 - f32(_e1923))));
let _e1948 = (_e1763 * 1024f);
let _e1950 = select(0f, _e1948, (_e1948 > 0f));
let _e1952 = select(_e1783, _e1950, (_e1950 < _e1783));
let _e1959 = select(0i, select(select(i32(_e1952), i32(-2147483648), (_e1952 < -2147483600f)), 2147483647i, (_e1952 > 2147483500f)), (_e1952 == _e1952));
let _e1963 = (_e1959 - select(0i, 1i, (_e1952 < f32(_e1959))));
let _e1964 = (262147i + _e1963);
let _e1966 = select(_e1801, _e1964, (_e1964 < _e1801));
let _e1972 = global_4.member[bitcast<u32>(select(0i, _e1966, (_e1966 > 0i)))];
let _e1987 = ((_e1836 + (f32(bitcast<i32>((_e1972 >> bitcast<u32>(12u)))) * _e1845)) + ((f32((bitcast<i32>((_e1972 & 4095u)) - 2048i)) * _e1826) * (_e1948 - f32(_e1963))));
let _e1988 = (_e1769 * 1024f);
let _e1990 = select(0f, _e1988, (_e1988 > 0f));
let _e1992 = select(_e1783, _e1990, (_e1990 < _e1783));
let _e1999 = select(0i, select(select(i32(_e1992), i32(-2147483648), (_e1992 < -2147483600f)), 2147483647i, (_e1992 > 2147483500f)), (_e1992 == _e1992));
let _e2003 = (_e1999 - select(0i, 1i, (_e1992 < f32(_e1999))));
let _e2004 = (262147i + _e2003);
let _e2006 = select(_e1801, _e2004, (_e2004 < _e1801));
let _e2012 = global_4.member[bitcast<u32>(select(0i, _e2006, (_e2006 > 0i)))];
let _e2027 = ((_e1836 + (f32(bitcast<i32>((_e2012 >> bitcast<u32>(12u)))) * _e1845)) + ((f32((bitcast<i32>((_e2012 & 4095u)) - 2048i)) * _e1826) * (_e1988 - f32(_e2003))));
let _e2028 = (_e1775 * 1024f);
let _e2030 = select(0f, _e2028, (_e2028 > 0f));
let _e2032 = select(_e1783, _e2030, (_e2030 < _e1783));
let _e2039 = select(0i, select(select(i32(_e2032), i32(-2147483648), (_e2032 < -2147483600f)), 2147483647i, (_e2032 > 2147483500f)), (_e2032 == _e2032));
let _e2043 = (_e2039 - select(0i, 1i, (_e2032 < f32(_e2039))));
let _e2044 = (262147i + _e2043);
let _e2046 = select(_e1801, _e2044, (_e2044 < _e1801));
let _e2052 = global_4.member[bitcast<u32>(select(0i, _e2046, (_e2046 > 0i)))];
let _e2067 = ((_e1836 + (f32(bitcast<i32>((_e2052 >> bitcast<u32>(12u)))) * _e1845)) + ((f32((bitcast<i32>((_e2052 & 4095u)) - 2048i)) * _e1826) * (_e2028 - f32(_e2043))));
let _e2068 = (_e1781 * 1024f);
let _e2070 = select(0f, _e2068, (_e2068 > 0f));
let _e2072 = select(_e1783, _e2070, (_e2070 < _e1783));
let _e2079 = select(0i, select(select(i32(_e2072), i32(-2147483648), (_e2072 < -2147483600f)), 2147483647i, (_e2072 > 2147483500f)), (_e2072 == _e2072));
let _e2083 = (_e2079 - select(0i, 1i, (_e2072 < f32(_e2079))));
let _e2084 = (262147i + _e2083);
let _e2086 = select(_e1801, _e2084, (_e2084 < _e1801));
let _e2092 = global_4.member[bitcast<u32>(select(0i, _e2086, (_e2086 > 0i)))];
let _e2107 = ((_e1836 + (f32(bitcast<i32>((_e2092 >> bitcast<u32>(12u)))) * _e1845)) + ((f32((bitcast<i32>((_e2092 & 4095u)) - 2048i)) * _e1826) * (_e2068 - f32(_e2083))));
let _e2108 = (_e1947 - _e1907);
let _e2110 = (_e2027 - _e1987);
let _e2112 = (_e2107 - _e2067);
phi_5591_ = type_29(_e1851, vec3<f32>((0.5f * _e2108), (0.5f * _e2110), (0.5f * _e2112)), vec3<f32>((0.25f * (_e2108 * (_e1947 + _e1907))), (0.25f * (_e2110 * (_e2027 + _e1987))), (0.25f * (_e2112 * (_e2107 + _e2067)))));
}
let _e2127 = phi_5591_;
let _e2142 = select(0f, 1f, ((((((_e662 >= -0.5f) && (_e662 <= _e684)) && (_e668 >= -0.5f)) && (_e668 <= _e694)) && (_e674 >= -0.5f)) && (_e674 <= _e704)));
let _e2144 = (0.5f * (_e1757 - _e1751));
let _e2146 = (0.5f * (_e1769 - _e1763));
let _e2148 = (0.5f * (_e1781 - _e1775));
let _e2154 = global_1.member.member_7.member.member.member;
let _e2160 = global_1.member.member_7.member.member.member_1;
let _e2166 = global_1.member.member_7.member.member.member_2;
let _e2172 = global_1.member.member_7.member_1.member.member;
let _e2178 = global_1.member.member_7.member_1.member.member_1;
let _e2184 = global_1.member.member_7.member_1.member.member_2;
let _e2190 = global_1.member.member_7.member_2.member.member;
let _e2196 = global_1.member.member_7.member_2.member.member_1;
let _e2202 = global_1.member.member_7.member_2.member.member_2;
phi_6237_ = type_30(select(1f, _e1101, (_e1101 < 1f)), vec3<f32>(((((_e2154 * _e2144) + (_e2172 * _e2146)) + (_e2190 * _e2148)) * _e2142), ((((_e2160 * _e2144) + (_e2178 * _e2146)) + (_e2196 * _e2148)) * _e2142), ((((_e2166 * _e2144) + (_e2184 * _e2146)) + (_e2202 * _e2148)) * _e2142)), _e2127.member, vec3<f32>(((((_e2154 * _e2127.member_2.x) + (_e2172 * _e2127.member_2.y)) + (_e2190 * _e2127.member_2.z)) * _e2142), ((((_e2160 * _e2127.member_2.x) + (_e2178 * _e2127.member_2.y)) + (_e2196 * _e2127.member_2.z)) * _e2142), ((((_e2166 * _e2127.member_2.x) + (_e2184 * _e2127.member_2.y)) + (_e2202 * _e2127.member_2.z)) * _e2142)), vec3<f32>(((((_e2154 * _e2127.member_1.x) + (_e2172 * _e2127.member_1.y)) + (_e2190 * _e2127.member_1.z)) * _e2142), ((((_e2160 * _e2127.member_1.x) + (_e2178 * _e2127.member_1.y)) + (_e2196 * _e2127.member_1.z)) * _e2142), ((((_e2166 * _e2127.member_1.x) + (_e2184 * _e2127.member_1.y)) + (_e2202 * _e2127.member_1.z)) * _e2142)));
} else {
let _e2268 = select(-1f, _e460, (_e460 > -1f));
let _e2270 = select(_e455, _e2268, (_e2268 < _e455));
let _e2277 = select(0i, select(select(i32(_e2270), i32(-2147483648), (_e2270 < -2147483600f)), 2147483647i, (_e2270 > 2147483500f)), (_e2270 == _e2270));
let _e2281 = (_e2277 - select(0i, 1i, (_e2270 < f32(_e2277))));
let _e2283 = select(-1f, _e470, (_e470 > -1f));
let _e2285 = select(_e465, _e2283, (_e2283 < _e465));
let _e2292 = select(0i, select(select(i32(_e2285), i32(-2147483648), (_e2285 < -2147483600f)), 2147483647i, (_e2285 > 2147483500f)), (_e2285 == _e2285));
let _e2296 = (_e2292 - select(0i, 1i, (_e2285 < f32(_e2292))));
let _e2298 = select(-1f, _e480, (_e480 > -1f));
let _e2300 = select(_e475, _e2298, (_e2298 < _e475));
let _e2307 = select(0i, select(select(i32(_e2300), i32(-2147483648), (_e2300 < -2147483600f)), 2147483647i, (_e2300 > 2147483500f)), (_e2300 == _e2300));
let _e2311 = (_e2307 - select(0i, 1i, (_e2300 < f32(_e2307))));
let _e2315 = global_1.member.member_6.member_7;
let _e2319 = global_1.member.member_6.member_8;
let _e2327 = (select(0i, select(select(i32(_e465), i32(-2147483648), (_e465 < -2147483600f)), 2147483647i, (_e465 > 2147483500f)), (_e465 == _e465)) - 1i);
let _e2330 = (_e2296 + 1i);
let _e2340 = (select(0i, select(select(i32(_e475), i32(-2147483648), (_e475 < -2147483600f)), 2147483647i, (_e475 > 2147483500f)), (_e475 == _e475)) - 1i);
let _e2343 = (_e2311 + 1i);
let _e2353 = (select(0i, select(select(i32(_e455), i32(-2147483648), (_e455 < -2147483600f)), 2147483647i, (_e455 > 2147483500f)), (_e455 == _e455)) - 1i);
let _e2354 = (_e2281 - 1i);
let _e2359 = (_e2281 + 1i);
let _e2362 = (_e2281 + 2i);
let _e2365 = (select(0i, _e2296, (_e2296 > 0i)) * _e2315);
let _e2366 = (select(_e2327, _e2330, (_e2330 < _e2327)) * _e2315);
let _e2367 = (select(0i, _e2311, (_e2311 > 0i)) * _e2319);
let _e2368 = (select(_e2340, _e2343, (_e2343 < _e2340)) * _e2319);
local_2 = type_28(array<i32, 4>(select(0i, _e2354, (_e2354 > 0i)), select(0i, _e2281, (_e2281 > 0i)), select(_e2353, _e2359, (_e2359 < _e2353)), select(_e2353, _e2362, (_e2362 < _e2353))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e460 - f32(_e2281)), (_e470 - f32(_e2296)), (_e480 - f32(_e2311)));
let _e2379 = (_e2367 + _e2365);
let _e2382 = local_2.member[1u];
let _e2383 = (_e2379 + _e2382);
let _e2385 = (bitcast<i32>(_e91) - 1i);
let _e2387 = select(_e2385, _e2383, (_e2383 < _e2385));
let _e2392 = global_2.member[bitcast<u32>(select(0i, _e2387, (_e2387 > 0i)))];
let _e2393 = bitcast<f32>(_e2392);
let _e2396 = local_2.member[2u];
let _e2397 = (_e2379 + _e2396);
let _e2399 = select(_e2385, _e2397, (_e2397 < _e2385));
let _e2404 = global_2.member[bitcast<u32>(select(0i, _e2399, (_e2399 > 0i)))];
let _e2406 = local_3[0u];
let _e2409 = (_e2393 + ((bitcast<f32>(_e2404) - _e2393) * _e2406));
let _e2410 = (_e2367 + _e2366);
let _e2411 = local_2.member[1u];
let _e2412 = (_e2410 + _e2411);
let _e2414 = select(_e2385, _e2412, (_e2412 < _e2385));
let _e2419 = global_2.member[bitcast<u32>(select(0i, _e2414, (_e2414 > 0i)))];
let _e2420 = bitcast<f32>(_e2419);
let _e2421 = local_2.member[2u];
let _e2422 = (_e2410 + _e2421);
let _e2424 = select(_e2385, _e2422, (_e2422 < _e2385));
let _e2429 = global_2.member[bitcast<u32>(select(0i, _e2424, (_e2424 > 0i)))];
let _e2431 = local_3[0u];
let _e2436 = local_3[1u];
let _e2439 = (_e2409 + (((_e2420 + ((bitcast<f32>(_e2429) - _e2420) * _e2431)) - _e2409) * _e2436));
let _e2440 = (_e2368 + _e2365);
let _e2441 = local_2.member[1u];
let _e2442 = (_e2440 + _e2441);
let _e2444 = select(_e2385, _e2442, (_e2442 < _e2385));
let _e2449 = global_2.member[bitcast<u32>(select(0i, _e2444, (_e2444 > 0i)))];
let _e2450 = bitcast<f32>(_e2449);
let _e2451 = local_2.member[2u];
let _e2452 = (_e2440 + _e2451);
let _e2454 = select(_e2385, _e2452, (_e2452 < _e2385));
let _e2459 = global_2.member[bitcast<u32>(select(0i, _e2454, (_e2454 > 0i)))];
let _e2461 = local_3[0u];
let _e2464 = (_e2450 + ((bitcast<f32>(_e2459) - _e2450) * _e2461));
let _e2465 = (_e2368 + _e2366);
let _e2466 = local_2.member[1u];
let _e2467 = (_e2465 + _e2466);
let _e2469 = select(_e2385, _e2467, (_e2467 < _e2385));
let _e2474 = global_2.member[bitcast<u32>(select(0i, _e2469, (_e2469 > 0i)))];
let _e2475 = bitcast<f32>(_e2474);
let _e2476 = local_2.member[2u];
let _e2477 = (_e2465 + _e2476);
let _e2479 = select(_e2385, _e2477, (_e2477 < _e2385));
let _e2484 = global_2.member[bitcast<u32>(select(0i, _e2479, (_e2479 > 0i)))];
let _e2486 = local_3[0u];
let _e2490 = local_3[1u];
let _e2495 = local_3[2u];
let _e2502 = global_1.member.member_6.member_5;
let _e2507 = global_1.member.member_6.member_6;
let _e2508 = (((_e2439 + (((_e2464 + (((_e2475 + ((bitcast<f32>(_e2484) - _e2475) * _e2486)) - _e2464) * _e2490)) - _e2439) * _e2495)) * _e2502) + _e2507);
let _e2510 = select(0f, _e2508, (_e2508 > 0f));
phi_6237_ = type_30(select(1f, _e2510, (_e2510 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2515 = phi_6237_;
let _e2517 = select(-0.5f, _e398, (_e398 > -0.5f));
let _e2519 = select(_e456, _e2517, (_e2517 < _e456));
let _e2521 = select(-0.5f, _e413, (_e413 > -0.5f));
let _e2523 = select(_e466, _e2521, (_e2521 < _e466));
let _e2525 = select(-0.5f, _e428, (_e428 > -0.5f));
let _e2527 = select(_e476, _e2525, (_e2525 < _e476));
let _e2529 = select(-1f, _e2519, (_e2519 > -1f));
let _e2531 = select(_e455, _e2529, (_e2529 < _e455));
let _e2538 = select(0i, select(select(i32(_e2531), i32(-2147483648), (_e2531 < -2147483600f)), 2147483647i, (_e2531 > 2147483500f)), (_e2531 == _e2531));
let _e2542 = (_e2538 - select(0i, 1i, (_e2531 < f32(_e2538))));
let _e2544 = select(-1f, _e2523, (_e2523 > -1f));
let _e2546 = select(_e465, _e2544, (_e2544 < _e465));
let _e2553 = select(0i, select(select(i32(_e2546), i32(-2147483648), (_e2546 < -2147483600f)), 2147483647i, (_e2546 > 2147483500f)), (_e2546 == _e2546));
let _e2557 = (_e2553 - select(0i, 1i, (_e2546 < f32(_e2553))));
let _e2559 = select(-1f, _e2527, (_e2527 > -1f));
let _e2561 = select(_e475, _e2559, (_e2559 < _e475));
let _e2568 = select(0i, select(select(i32(_e2561), i32(-2147483648), (_e2561 < -2147483600f)), 2147483647i, (_e2561 > 2147483500f)), (_e2561 == _e2561));
let _e2572 = (_e2568 - select(0i, 1i, (_e2561 < f32(_e2568))));
let _e2576 = global_1.member.member_6.member_7;
let _e2580 = global_1.member.member_6.member_8;
let _e2588 = (select(0i, select(select(i32(_e465), i32(-2147483648), (_e465 < -2147483600f)), 2147483647i, (_e465 > 2147483500f)), (_e465 == _e465)) - 1i);
let _e2591 = (_e2557 + 1i);
let _e2601 = (select(0i, select(select(i32(_e475), i32(-2147483648), (_e475 < -2147483600f)), 2147483647i, (_e475 > 2147483500f)), (_e475 == _e475)) - 1i);
let _e2604 = (_e2572 + 1i);
let _e2614 = (select(0i, select(select(i32(_e455), i32(-2147483648), (_e455 < -2147483600f)), 2147483647i, (_e455 > 2147483500f)), (_e455 == _e455)) - 1i);
let _e2615 = (_e2542 - 1i);
let _e2620 = (_e2542 + 1i);
let _e2623 = (_e2542 + 2i);
let _e2626 = (select(0i, _e2557, (_e2557 > 0i)) * _e2576);
let _e2627 = (select(_e2588, _e2591, (_e2591 < _e2588)) * _e2576);
let _e2628 = (select(0i, _e2572, (_e2572 > 0i)) * _e2580);
let _e2629 = (select(_e2601, _e2604, (_e2604 < _e2601)) * _e2580);
local = type_28(array<i32, 4>(select(0i, _e2615, (_e2615 > 0i)), select(0i, _e2542, (_e2542 > 0i)), select(_e2614, _e2620, (_e2620 < _e2614)), select(_e2614, _e2623, (_e2623 < _e2614))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_1 = vec3<f32>((_e2519 - f32(_e2542)), (_e2523 - f32(_e2557)), (_e2527 - f32(_e2572)));
let _e2640 = (_e2628 + _e2626);
let _e2643 = local.member[1u];
let _e2644 = (_e2640 + _e2643);
let _e2646 = (bitcast<i32>(_e91) - 1i);
let _e2648 = select(_e2646, _e2644, (_e2644 < _e2646));
let _e2653 = global_2.member[bitcast<u32>(select(0i, _e2648, (_e2648 > 0i)))];
let _e2654 = bitcast<f32>(_e2653);
let _e2657 = local.member[2u];
let _e2658 = (_e2640 + _e2657);
let _e2660 = select(_e2646, _e2658, (_e2658 < _e2646));
let _e2665 = global_2.member[bitcast<u32>(select(0i, _e2660, (_e2660 > 0i)))];
let _e2667 = local_1[0u];
let _e2670 = (_e2654 + ((bitcast<f32>(_e2665) - _e2654) * _e2667));
let _e2671 = (_e2628 + _e2627);
let _e2672 = local.member[1u];
let _e2673 = (_e2671 + _e2672);
let _e2675 = select(_e2646, _e2673, (_e2673 < _e2646));
let _e2680 = global_2.member[bitcast<u32>(select(0i, _e2675, (_e2675 > 0i)))];
let _e2681 = bitcast<f32>(_e2680);
let _e2682 = local.member[2u];
let _e2683 = (_e2671 + _e2682);
let _e2685 = select(_e2646, _e2683, (_e2683 < _e2646));
let _e2690 = global_2.member[bitcast<u32>(select(0i, _e2685, (_e2685 > 0i)))];
let _e2692 = local_1[0u];
let _e2697 = local_1[1u];
let _e2700 = (_e2670 + (((_e2681 + ((bitcast<f32>(_e2690) - _e2681) * _e2692)) - _e2670) * _e2697));
let _e2701 = (_e2629 + _e2626);
let _e2702 = local.member[1u];
let _e2703 = (_e2701 + _e2702);
let _e2705 = select(_e2646, _e2703, (_e2703 < _e2646));
let _e2710 = global_2.member[bitcast<u32>(select(0i, _e2705, (_e2705 > 0i)))];
let _e2711 = bitcast<f32>(_e2710);
let _e2712 = local.member[2u];
let _e2713 = (_e2701 + _e2712);
let _e2715 = select(_e2646, _e2713, (_e2713 < _e2646));
let _e2720 = global_2.member[bitcast<u32>(select(0i, _e2715, (_e2715 > 0i)))];
let _e2722 = local_1[0u];
let _e2725 = (_e2711 + ((bitcast<f32>(_e2720) - _e2711) * _e2722));
let _e2726 = (_e2629 + _e2627);
let _e2727 = local.member[1u];
let _e2728 = (_e2726 + _e2727);
let _e2730 = select(_e2646, _e2728, (_e2728 < _e2646));
let _e2735 = global_2.member[bitcast<u32>(select(0i, _e2730, (_e2730 > 0i)))];
let _e2736 = bitcast<f32>(_e2735);
let _e2737 = local.member[2u];
let _e2738 = (_e2726 + _e2737);
let _e2740 = select(_e2646, _e2738, (_e2738 < _e2646));
let _e2745 = global_2.member[bitcast<u32>(select(0i, _e2740, (_e2740 > 0i)))];
let _e2747 = local_1[0u];
let _e2751 = local_1[1u];
let _e2756 = local_1[2u];
let _e2763 = global_1.member.member_6.member_5;
let _e2768 = global_1.member.member_6.member_6;
let _e2769 = (((_e2700 + (((_e2725 + (((_e2736 + ((bitcast<f32>(_e2745) - _e2736) * _e2747)) - _e2725) * _e2751)) - _e2700) * _e2756)) * _e2763) + _e2768);
let _e2771 = select(0f, _e2769, (_e2769 > 0f));
if ((_e840 & 16u) == 0u) {
phi_7106_ = type_5(1f, 1f, 1f);
} else {
let _e2779 = global_1.member.member_14.member;
let _e2790 = ((((_e2779.member.member * _e309) + (_e2779.member.member_1 * _e318)) + (_e2779.member.member_2 * _e291)) + _e2779.member_1);
let _e2796 = ((((_e2779.member.member * _e330) + (_e2779.member.member_1 * _e335)) + (_e2779.member.member_2 * _e324)) + _e2779.member_1);
let _e2798 = select(_e2796, _e2790, (_e2790 < _e2796));
let _e2800 = select(_e2796, _e2790, (_e2790 > _e2796));
let _e2802 = (_e2800 - _e2798);
let _e2805 = (-(_e2798) / select(1e-30f, _e2802, (_e2802 > 1e-30f)));
let _e2807 = select(0f, _e2805, (_e2805 > 0f));
let _e2813 = select(select(select(1f, _e2807, (_e2807 < 1f)), 1f, (_e2800 <= 0f)), 0f, (_e2798 > 0f));
let _e2818 = global_1.member.member_14.member_1;
let _e2819 = (_e2818 != 0u);
let _e2829 = global_1.member.member_15.member;
let _e2840 = ((((_e2829.member.member * _e309) + (_e2829.member.member_1 * _e318)) + (_e2829.member.member_2 * _e291)) + _e2829.member_1);
let _e2846 = ((((_e2829.member.member * _e330) + (_e2829.member.member_1 * _e335)) + (_e2829.member.member_2 * _e324)) + _e2829.member_1);
let _e2848 = select(_e2846, _e2840, (_e2840 < _e2846));
let _e2850 = select(_e2846, _e2840, (_e2840 > _e2846));
let _e2852 = (_e2850 - _e2848);
let _e2855 = (-(_e2848) / select(1e-30f, _e2852, (_e2852 > 1e-30f)));
let _e2857 = select(0f, _e2855, (_e2855 > 0f));
let _e2863 = select(select(select(1f, _e2857, (_e2857 < 1f)), 1f, (_e2850 <= 0f)), 0f, (_e2848 > 0f));
let _e2868 = global_1.member.member_15.member_1;
let _e2869 = (_e2868 != 0u);
let _e2879 = global_1.member.member_16.member;
let _e2890 = ((((_e2879.member.member * _e309) + (_e2879.member.member_1 * _e318)) + (_e2879.member.member_2 * _e291)) + _e2879.member_1);
let _e2896 = ((((_e2879.member.member * _e330) + (_e2879.member.member_1 * _e335)) + (_e2879.member.member_2 * _e324)) + _e2879.member_1);
let _e2898 = select(_e2896, _e2890, (_e2890 < _e2896));
let _e2900 = select(_e2896, _e2890, (_e2890 > _e2896));
let _e2902 = (_e2900 - _e2898);
let _e2905 = (-(_e2898) / select(1e-30f, _e2902, (_e2902 > 1e-30f)));
let _e2907 = select(0f, _e2905, (_e2905 > 0f));
let _e2913 = select(select(select(1f, _e2907, (_e2907 < 1f)), 1f, (_e2900 <= 0f)), 0f, (_e2898 > 0f));
let _e2918 = global_1.member.member_16.member_1;
let _e2919 = (_e2918 != 0u);
let _e2929 = global_1.member.member_17.member;
let _e2940 = ((((_e2929.member.member * _e309) + (_e2929.member.member_1 * _e318)) + (_e2929.member.member_2 * _e291)) + _e2929.member_1);
let _e2946 = ((((_e2929.member.member * _e330) + (_e2929.member.member_1 * _e335)) + (_e2929.member.member_2 * _e324)) + _e2929.member_1);
let _e2948 = select(_e2946, _e2940, (_e2940 < _e2946));
let _e2950 = select(_e2946, _e2940, (_e2940 > _e2946));
let _e2952 = (_e2950 - _e2948);
let _e2955 = (-(_e2948) / select(1e-30f, _e2952, (_e2952 > 1e-30f)));
let _e2957 = select(0f, _e2955, (_e2955 > 0f));
let _e2963 = select(select(select(1f, _e2957, (_e2957 < 1f)), 1f, (_e2950 <= 0f)), 0f, (_e2948 > 0f));
let _e2968 = global_1.member.member_17.member_1;
let _e2969 = (_e2968 != 0u);
phi_7106_ = type_5(((((1f * _e2813) * _e2863) * _e2913) * _e2963), ((((1f * select(1f, _e2813, _e2819)) * select(1f, _e2863, _e2869)) * select(1f, _e2913, _e2919)) * select(1f, _e2963, _e2969)), ((((1f * select(1f, 0f, (_e2819 && (_e2796 > 0f)))) * select(1f, 0f, (_e2869 && (_e2846 > 0f)))) * select(1f, 0f, (_e2919 && (_e2896 > 0f)))) * select(1f, 0f, (_e2969 && (_e2946 > 0f)))));
}
let _e2978 = phi_7106_;
let _e2979 = (_e330 - _e309);
let _e2980 = (_e335 - _e318);
let _e2981 = (_e324 - _e291);
let _e2986 = (((_e2979 * _e2979) + (_e2980 * _e2980)) + (_e2981 * _e2981));
let _e2990 = (_e486 < 1e-12f);
let _e2992 = (1f / select(_e481, 1f, _e2990));
let _e2994 = ((-0.5f - _e398) * _e2992);
let _e2996 = ((_e456 - _e398) * _e2992);
let _e3002 = select(_e2996, _e2994, (_e2994 < _e2996));
let _e3004 = select(0f, _e3002, (_e3002 > 0f));
let _e3007 = select(select(1f, _e3004, (_e3004 < 1f)), select(2f, 0f, ((_e398 >= -0.5f) && (_e398 <= _e456))), _e2990);
let _e3009 = select(_e2996, _e2994, (_e2994 > _e2996));
let _e3011 = select(0f, _e3009, (_e3009 > 0f));
let _e3014 = select(select(1f, _e3011, (_e3011 < 1f)), 1f, _e2990);
let _e3015 = (_e489 < 1e-12f);
let _e3017 = (1f / select(_e482, 1f, _e3015));
let _e3019 = ((-0.5f - _e413) * _e3017);
let _e3021 = ((_e466 - _e413) * _e3017);
let _e3027 = select(_e3021, _e3019, (_e3019 < _e3021));
let _e3029 = select(0f, _e3027, (_e3027 > 0f));
let _e3032 = select(select(1f, _e3029, (_e3029 < 1f)), select(2f, 0f, ((_e413 >= -0.5f) && (_e413 <= _e466))), _e3015);
let _e3034 = select(_e3021, _e3019, (_e3019 > _e3021));
let _e3036 = select(0f, _e3034, (_e3034 > 0f));
let _e3039 = select(select(1f, _e3036, (_e3036 < 1f)), 1f, _e3015);
let _e3040 = (_e494 < 1e-12f);
let _e3042 = (1f / select(_e483, 1f, _e3040));
let _e3044 = ((-0.5f - _e428) * _e3042);
let _e3046 = ((_e476 - _e428) * _e3042);
let _e3052 = select(_e3046, _e3044, (_e3044 < _e3046));
let _e3054 = select(0f, _e3052, (_e3052 > 0f));
let _e3057 = select(select(1f, _e3054, (_e3054 < 1f)), select(2f, 0f, ((_e428 >= -0.5f) && (_e428 <= _e476))), _e3040);
let _e3059 = select(_e3046, _e3044, (_e3044 > _e3046));
let _e3061 = select(0f, _e3059, (_e3059 > 0f));
let _e3064 = select(select(1f, _e3061, (_e3061 < 1f)), 1f, _e3040);
let _e3066 = select(_e3039, _e3014, (_e3014 < _e3039));
let _e3070 = select(_e3032, _e3007, (_e3007 > _e3032));
let _e3073 = (select(_e3064, _e3066, (_e3066 < _e3064)) - select(_e3057, _e3070, (_e3070 > _e3057)));
let _e3080 = global_1.member.member_5.member_3;
let _e3081 = ((sqrt(select(0f, _e2986, (_e2986 > 0f))) * select(0f, _e3073, (_e3073 > 0f))) * _e3080);
let _e3083 = (select(1f, _e2771, (_e2771 < 1f)) * 255f);
let _e3084 = (_e2515.member * 255f);
let _e3085 = (255f - 1f);
let _e3087 = select(0f, _e3083, (_e3083 > 0f));
let _e3089 = select(_e3085, _e3087, (_e3087 < _e3085));
let _e3096 = select(0i, select(select(i32(_e3089), i32(-2147483648), (_e3089 < -2147483600f)), 2147483647i, (_e3089 > 2147483500f)), (_e3089 == _e3089));
let _e3100 = (_e3096 - select(0i, 1i, (_e3089 < f32(_e3096))));
let _e3102 = select(0f, _e3084, (_e3084 > 0f));
let _e3104 = select(_e3085, _e3102, (_e3102 < _e3085));
let _e3111 = select(0i, select(select(i32(_e3104), i32(-2147483648), (_e3104 < -2147483600f)), 2147483647i, (_e3104 > 2147483500f)), (_e3104 == _e3104));
let _e3115 = (_e3111 - select(0i, 1i, (_e3104 < f32(_e3111))));
let _e3118 = (((_e3100 * 256i) + _e3115) * 4i);
let _e3120 = (_e3083 - f32(_e3100));
let _e3122 = (_e3084 - f32(_e3115));
let _e3124 = (bitcast<i32>(_e98) - 1i);
let _e3126 = select(_e3124, _e3118, (_e3118 < _e3124));
let _e3132 = global_4.member[bitcast<u32>(select(0i, _e3126, (_e3126 > 0i)))];
let _e3133 = (_e3118 + 4i);
let _e3135 = select(_e3124, _e3133, (_e3133 < _e3124));
let _e3141 = global_4.member[bitcast<u32>(select(0i, _e3135, (_e3135 > 0i)))];
let _e3142 = (_e3118 + 1024i);
let _e3144 = select(_e3124, _e3142, (_e3142 < _e3124));
let _e3150 = global_4.member[bitcast<u32>(select(0i, _e3144, (_e3144 > 0i)))];
let _e3151 = (_e3118 + 1028i);
let _e3153 = select(_e3124, _e3151, (_e3151 < _e3124));
let _e3159 = global_4.member[bitcast<u32>(select(0i, _e3153, (_e3153 > 0i)))];
let _e3164 = (bitcast<f32>(((_e3132 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3172 = (_e3164 + (((bitcast<f32>(((_e3141 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3164) * _e3122));
let _e3177 = (bitcast<f32>(((_e3150 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3201 = (bitcast<f32>((((_e3132 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3209 = (_e3201 + (((bitcast<f32>((((_e3141 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3201) * _e3122));
let _e3214 = (bitcast<f32>((((_e3150 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3226 = (_e3118 + 1i);
let _e3228 = select(_e3124, _e3226, (_e3226 < _e3124));
let _e3234 = global_4.member[bitcast<u32>(select(0i, _e3228, (_e3228 > 0i)))];
let _e3235 = (_e3118 + 5i);
let _e3237 = select(_e3124, _e3235, (_e3235 < _e3124));
let _e3243 = global_4.member[bitcast<u32>(select(0i, _e3237, (_e3237 > 0i)))];
let _e3244 = (_e3118 + 1025i);
let _e3246 = select(_e3124, _e3244, (_e3244 < _e3124));
let _e3252 = global_4.member[bitcast<u32>(select(0i, _e3246, (_e3246 > 0i)))];
let _e3253 = (_e3118 + 1029i);
let _e3255 = select(_e3124, _e3253, (_e3253 < _e3124));
let _e3261 = global_4.member[bitcast<u32>(select(0i, _e3255, (_e3255 > 0i)))];
let _e3266 = (bitcast<f32>(((_e3234 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3274 = (_e3266 + (((bitcast<f32>(((_e3243 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3266) * _e3122));
let _e3279 = (bitcast<f32>(((_e3252 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3303 = (bitcast<f32>((((_e3234 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3311 = (_e3303 + (((bitcast<f32>((((_e3243 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3303) * _e3122));
let _e3316 = (bitcast<f32>((((_e3252 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3331 = (_e3081 * _e2978.member_1);
let _e3333 = -(((_e3209 + (((_e3214 + (((bitcast<f32>((((_e3159 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3214) * _e3122)) - _e3209) * _e3120)) * _e3331));
let _e3335 = select(-87f, _e3333, (_e3333 > -87f));
let _e3337 = select(88f, _e3335, (_e3335 < 88f));
let _e3339 = ((_e3337 * 1.442695f) + 0.5f);
let _e3341 = select(-127f, _e3339, (_e3339 > -127f));
let _e3343 = select(128f, _e3341, (_e3341 < 128f));
let _e3350 = select(0i, select(select(i32(_e3343), i32(-2147483648), (_e3343 < -2147483600f)), 2147483647i, (_e3343 > 2147483500f)), (_e3343 == _e3343));
let _e3354 = (_e3350 - select(0i, 1i, (_e3343 < f32(_e3350))));
let _e3355 = f32(_e3354);
let _e3359 = ((_e3337 - (_e3355 * 0.6933594f)) - (_e3355 * -2.1219444e-4f));
let _e3381 = -(((_e3274 + (((_e3279 + (((bitcast<f32>(((_e3261 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3279) * _e3122)) - _e3274) * _e3120)) * _e3331));
let _e3383 = select(-87f, _e3381, (_e3381 > -87f));
let _e3385 = select(88f, _e3383, (_e3383 < 88f));
let _e3387 = ((_e3385 * 1.442695f) + 0.5f);
let _e3389 = select(-127f, _e3387, (_e3387 > -127f));
let _e3391 = select(128f, _e3389, (_e3389 < 128f));
let _e3398 = select(0i, select(select(i32(_e3391), i32(-2147483648), (_e3391 < -2147483600f)), 2147483647i, (_e3391 > 2147483500f)), (_e3391 == _e3391));
let _e3402 = (_e3398 - select(0i, 1i, (_e3391 < f32(_e3398))));
let _e3403 = f32(_e3402);
let _e3407 = ((_e3385 - (_e3403 * 0.6933594f)) - (_e3403 * -2.1219444e-4f));
let _e3429 = -(((_e3311 + (((_e3316 + (((bitcast<f32>((((_e3261 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3316) * _e3122)) - _e3311) * _e3120)) * _e3331));
let _e3431 = select(-87f, _e3429, (_e3429 > -87f));
let _e3433 = select(88f, _e3431, (_e3431 < 88f));
let _e3435 = ((_e3433 * 1.442695f) + 0.5f);
let _e3437 = select(-127f, _e3435, (_e3435 > -127f));
let _e3439 = select(128f, _e3437, (_e3437 < 128f));
let _e3446 = select(0i, select(select(i32(_e3439), i32(-2147483648), (_e3439 < -2147483600f)), 2147483647i, (_e3439 > 2147483500f)), (_e3439 == _e3439));
let _e3450 = (_e3446 - select(0i, 1i, (_e3439 < f32(_e3446))));
let _e3451 = f32(_e3450);
let _e3455 = ((_e3433 - (_e3451 * 0.6933594f)) - (_e3451 * -2.1219444e-4f));
let _e3477 = -(((_e3172 + (((_e3177 + (((bitcast<f32>(((_e3159 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3177) * _e3122)) - _e3172) * _e3120)) * (_e3081 * _e2978.member)));
let _e3479 = select(-87f, _e3477, (_e3477 > -87f));
let _e3481 = select(88f, _e3479, (_e3479 < 88f));
let _e3483 = ((_e3481 * 1.442695f) + 0.5f);
let _e3485 = select(-127f, _e3483, (_e3483 > -127f));
let _e3487 = select(128f, _e3485, (_e3485 < 128f));
let _e3494 = select(0i, select(select(i32(_e3487), i32(-2147483648), (_e3487 < -2147483600f)), 2147483647i, (_e3487 > 2147483500f)), (_e3487 == _e3487));
let _e3498 = (_e3494 - select(0i, 1i, (_e3487 < f32(_e3494))));
let _e3499 = f32(_e3498);
let _e3503 = ((_e3481 - (_e3499 * 0.6933594f)) - (_e3499 * -2.1219444e-4f));
let _e3523 = ((1f + (_e3503 * (1f + (_e3503 * (0.5f + (_e3503 * (0.16666667f + (_e3503 * (0.041666668f + (_e3503 * (0.008333334f + (_e3503 * (0.001388889f + (_e3503 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3498 + 127i)) << bitcast<u32>(23i))));
if _e857 {
let _e3538 = global_1.member.member_5.member_4;
let _e3541 = (_e2515.member_3.x * _e2978.member_2);
let _e3543 = (_e2515.member_3.y * _e2978.member_2);
let _e3545 = (_e2515.member_3.z * _e2978.member_2);
let _e3546 = (0.5f * (_e248 / _e199));
let _e3550 = (_e177 + (_e3541 * _e3546));
let _e3551 = (_e188 + (_e3543 * _e3546));
let _e3552 = (_e199 + (_e3545 * _e3546));
let _e3554 = (2f * _e248);
let _e3556 = ((_e3552 * _e3552) + (_e3554 * _e3545));
let _e3560 = (_e3552 + sqrt(select(0f, _e3556, (_e3556 > 0f))));
let _e3564 = (0.5f * (_e3554 / select(1e-6f, _e3560, (_e3560 > 1e-6f))));
let _e3568 = (_e3550 + (_e3541 * _e3564));
let _e3569 = (_e3551 + (_e3543 * _e3564));
let _e3570 = (_e3552 + (_e3545 * _e3564));
let _e3574 = (_e3538 * _e3538);
let _e3576 = (_e3570 * _e3570);
let _e3584 = (((_e3552 <= 0f) || (_e3556 <= 0f)) || ((_e3570 <= 0f) || (_e3576 <= (_e3574 * (((_e3568 * _e3568) + (_e3569 * _e3569)) + _e3576)))));
let _e3598 = (_e177 + ((_e2515.member_4.x * _e2978.member_2) * _e248));
let _e3599 = (_e188 + ((_e2515.member_4.y * _e2978.member_2) * _e248));
let _e3600 = (_e199 + ((_e2515.member_4.z * _e2978.member_2) * _e248));
let _e3602 = (_e3600 * _e3600);
let _e3611 = ((_e840 & 1u) != 0u);
phi_8132_ = vec3<f32>(select(select(select(_e3568, _e3550, _e3584), _e3598, _e3611), _e177, _e847), select(select(select(_e3569, _e3551, _e3584), _e3599, _e3611), _e188, _e847), select(select(select(_e3570, _e3552, _e3584), _e3600, _e3611), _e199, _e847));
phi_8133_ = (select(_e3584, ((_e3600 <= 0f) || (_e3602 <= (_e3574 * (((_e3598 * _e3598) + (_e3599 * _e3599)) + _e3602)))), _e3611) && !(_e847));
} else {
phi_8132_ = vec3<f32>(_e177, _e188, _e199);
phi_8133_ = false;
}
let _e3623 = phi_8132_;
let _e3625 = phi_8133_;
global_6.member[_e123] = (_e134 + _e263);
global_6.member[_e135] = (_e144 + _e270);
global_6.member[_e146] = (_e155 + _e372);
global_6.member[_e157] = (_e166 + _e375);
global_6.member[_e168] = _e3623.x;
global_6.member[_e179] = _e3623.y;
global_6.member[_e190] = _e3623.z;
global_6.member[_e201] = select((_e210 * (((1f + (_e3359 * (1f + (_e3359 * (0.5f + (_e3359 * (0.16666667f + (_e3359 * (0.041666668f + (_e3359 * (0.008333334f + (_e3359 * (0.001388889f + (_e3359 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3354 + 127i)) << bitcast<u32>(23i)))) * _e3523)), _e210, _e847);
global_6.member[_e212] = select((_e221 * (((1f + (_e3407 * (1f + (_e3407 * (0.5f + (_e3407 * (0.16666667f + (_e3407 * (0.041666668f + (_e3407 * (0.008333334f + (_e3407 * (0.001388889f + (_e3407 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3402 + 127i)) << bitcast<u32>(23i)))) * _e3523)), _e221, _e847);
global_6.member[_e223] = select((_e232 * (((1f + (_e3455 * (1f + (_e3455 * (0.5f + (_e3455 * (0.16666667f + (_e3455 * (0.041666668f + (_e3455 * (0.008333334f + (_e3455 * (0.001388889f + (_e3455 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3450 + 127i)) << bitcast<u32>(23i)))) * _e3523)), _e232, _e847);
global_6.member[_e234] = select(_e243, 1f, _e3625);
}
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
