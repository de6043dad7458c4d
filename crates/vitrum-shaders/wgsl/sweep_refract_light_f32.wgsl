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
struct type_31 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
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
@group(0) @binding(6)
var<storage, read_write> global_5: type_11;
@group(0) @binding(5)
var<storage> global_6: type_11;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var phi_938_: u32;
var phi_3193_: type_29;
var phi_3839_: type_30;
var phi_4672_: type_5;
var phi_5782_: type_31;
var phi_5934_: vec3<f32>;
var phi_5935_: f32;
let _e83 = global;
let _e86 = arrayLength((&global_2.member));
let _e90 = arrayLength((&global_4.member));
let _e92 = arrayLength((&global_6.member));
let _e97 = global_1.member.member_2;
let _e100 = global_1.member.member;
let _e108 = (_e83.x + _e97.member);
let _e110 = (_e83.y + _e97.member_1);
if (_e108 < _e97.member_2) {
if (_e110 < _e97.member_3) {
let _e113 = (_e100.member * _e100.member_1);
let _e115 = ((_e110 * _e100.member) + _e108);
let _e116 = bitcast<i32>(_e115);
let _e118 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e120 = select(_e118, _e116, (_e116 < _e118));
let _e126 = global_5.member[bitcast<u32>(select(0i, _e120, (_e120 > 0i)))];
let _e127 = (_e113 + _e115);
let _e128 = bitcast<i32>(_e127);
let _e130 = select(_e118, _e128, (_e128 < _e118));
let _e136 = global_5.member[bitcast<u32>(select(0i, _e130, (_e130 > 0i)))];
let _e138 = ((2u * _e113) + _e115);
let _e139 = bitcast<i32>(_e138);
let _e141 = select(_e118, _e139, (_e139 < _e118));
let _e147 = global_5.member[bitcast<u32>(select(0i, _e141, (_e141 > 0i)))];
let _e149 = ((3u * _e113) + _e115);
let _e150 = bitcast<i32>(_e149);
let _e152 = select(_e118, _e150, (_e150 < _e118));
let _e158 = global_5.member[bitcast<u32>(select(0i, _e152, (_e152 > 0i)))];
let _e160 = ((4u * _e113) + _e115);
let _e161 = bitcast<i32>(_e160);
let _e163 = select(_e118, _e161, (_e161 < _e118));
let _e169 = global_5.member[bitcast<u32>(select(0i, _e163, (_e163 > 0i)))];
let _e171 = ((5u * _e113) + _e115);
let _e172 = bitcast<i32>(_e171);
let _e174 = select(_e118, _e172, (_e172 < _e118));
let _e180 = global_5.member[bitcast<u32>(select(0i, _e174, (_e174 > 0i)))];
let _e182 = ((6u * _e113) + _e115);
let _e183 = bitcast<i32>(_e182);
let _e185 = select(_e118, _e183, (_e183 < _e118));
let _e191 = global_5.member[bitcast<u32>(select(0i, _e185, (_e185 > 0i)))];
let _e193 = ((7u * _e113) + _e115);
let _e194 = bitcast<i32>(_e193);
let _e196 = select(_e118, _e194, (_e194 < _e118));
let _e202 = global_5.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e204 = ((8u * _e113) + _e115);
let _e205 = bitcast<i32>(_e204);
let _e207 = select(_e118, _e205, (_e205 < _e118));
let _e213 = global_5.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e217 = global_1.member.member_8.member;
let _e221 = global_1.member.member_8.member_1;
let _e222 = (_e217 * _e221);
if (_e92 >= (_e222 * 2u)) {
let _e226 = bitcast<i32>((_e110 * _e217));
let _e228 = bitcast<i32>(_e108);
let _e233 = global_6.member[bitcast<u32>((_e226 + _e228))];
let _e239 = global_6.member[bitcast<u32>(((bitcast<i32>(_e222) + _e226) + _e228))];
let _e240 = f32(_e228);
let _e242 = f32(bitcast<i32>(_e110));
let _e248 = global_1.member.member_5.member;
let _e252 = global_1.member.member_8.member_8;
let _e253 = (_e248 - _e252);
let _e257 = global_1.member.member_8.member_2;
let _e261 = global_1.member.member_8.member_6;
let _e268 = global_1.member.member_8.member_4;
let _e270 = ((_e257 + (_e261 * _e253)) + (((_e240 - _e233) + 0.5f) * _e268));
let _e274 = global_1.member.member_8.member_3;
let _e278 = global_1.member.member_8.member_7;
let _e283 = ((_e274 + (_e278 * _e253)) + (((_e242 - _e239) + 0.5f) * _e268));
let _e287 = global_1.member.member_5.member_1;
let _e288 = (_e287 - _e252);
let _e293 = ((_e257 + (_e261 * _e288)) + ((_e240 + 0.5f) * _e268));
let _e298 = ((_e274 + (_e278 * _e288)) + ((_e242 + 0.5f) * _e268));
let _e302 = global_1.member.member_6.member;
let _e313 = ((((_e302.member.member * _e270) + (_e302.member.member_1 * _e283)) + (_e302.member.member_2 * _e248)) + _e302.member_1);
let _e317 = global_1.member.member_6.member_1;
let _e328 = ((((_e317.member.member * _e270) + (_e317.member.member_1 * _e283)) + (_e317.member.member_2 * _e248)) + _e317.member_1);
let _e332 = global_1.member.member_6.member_2;
let _e343 = ((((_e332.member.member * _e270) + (_e332.member.member_1 * _e283)) + (_e332.member.member_2 * _e248)) + _e332.member_1);
let _e349 = ((((_e302.member.member * _e293) + (_e302.member.member_1 * _e298)) + (_e302.member.member_2 * _e287)) + _e302.member_1);
let _e355 = ((((_e317.member.member * _e293) + (_e317.member.member_1 * _e298)) + (_e317.member.member_2 * _e287)) + _e317.member_1);
let _e361 = ((((_e332.member.member * _e293) + (_e332.member.member_1 * _e298)) + (_e332.member.member_2 * _e287)) + _e332.member_1);
let _e367 = global_1.member.member_6.member_3.member;
let _e368 = (_e367 - 1f);
let _e377 = global_1.member.member_6.member_3.member_1;
let _e378 = (_e377 - 1f);
let _e387 = global_1.member.member_6.member_3.member_2;
let _e388 = (_e387 - 1f);
let _e407 = global_1.member.member_6.member_4;
let _e408 = (_e367 - 0.5f);
let _e410 = select(-0.5f, _e349, (_e349 > -0.5f));
let _e412 = select(_e408, _e410, (_e410 < _e408));
let _e413 = (_e377 - 0.5f);
let _e415 = select(-0.5f, _e355, (_e355 > -0.5f));
let _e417 = select(_e413, _e415, (_e415 < _e413));
let _e418 = (_e387 - 0.5f);
let _e420 = select(-0.5f, _e361, (_e361 > -0.5f));
let _e422 = select(_e418, _e420, (_e420 < _e418));
let _e428 = bitcast<f32>((bitcast<u32>((_e349 - _e313)) & 2147483647u));
let _e431 = bitcast<f32>((bitcast<u32>((_e355 - _e328)) & 2147483647u));
let _e433 = select(_e431, _e428, (_e428 > _e431));
let _e436 = bitcast<f32>((bitcast<u32>((_e361 - _e343)) & 2147483647u));
let _e445 = bitcast<f32>((bitcast<u32>((_e349 - _e412)) & 2147483647u));
let _e448 = bitcast<f32>((bitcast<u32>((_e355 - _e417)) & 2147483647u));
let _e450 = select(_e448, _e445, (_e445 > _e448));
let _e453 = bitcast<f32>((bitcast<u32>((_e361 - _e422)) & 2147483647u));
let _e457 = (_e412 + 0.5f);
let _e459 = select(0f, _e457, (_e457 > 0f));
let _e461 = select(_e368, _e459, (_e459 < _e368));
let _e468 = select(0i, select(select(i32(_e461), i32(-2147483648), (_e461 < -2147483600f)), 2147483647i, (_e461 > 2147483500f)), (_e461 == _e461));
let _e476 = global_1.member.member_6.member_12;
let _e477 = (_e476 & 31u);
let _e480 = (_e417 + 0.5f);
let _e482 = select(0f, _e480, (_e480 > 0f));
let _e484 = select(_e378, _e482, (_e482 < _e378));
let _e491 = select(0i, select(select(i32(_e484), i32(-2147483648), (_e484 < -2147483600f)), 2147483647i, (_e484 > 2147483500f)), (_e484 == _e484));
let _e498 = (_e422 + 0.5f);
let _e500 = select(0f, _e498, (_e498 > 0f));
let _e502 = select(_e388, _e500, (_e500 < _e388));
let _e509 = select(0i, select(select(i32(_e502), i32(-2147483648), (_e502 < -2147483600f)), 2147483647i, (_e502 > 2147483500f)), (_e502 == _e502));
let _e520 = global_1.member.member_6.member_9.member;
let _e526 = global_1.member.member_6.member_9.member_1;
let _e531 = global_1.member.member_6.member_10;
let _e537 = ((bitcast<i32>(_e531) + ((_e468 - select(0i, 1i, (_e461 < f32(_e468)))) >> bitcast<u32>(_e477))) + (bitcast<i32>(_e520) * (((_e491 - select(0i, 1i, (_e484 < f32(_e491)))) >> bitcast<u32>(_e477)) + (bitcast<i32>(_e526) * ((_e509 - select(0i, 1i, (_e502 < f32(_e509)))) >> bitcast<u32>(_e477))))));
let _e539 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e541 = select(_e539, _e537, (_e537 < _e539));
let _e547 = global_3.member[bitcast<u32>(select(0i, _e541, (_e541 > 0i)))];
let _e553 = global_1.member.member_1;
phi_938_ = select(select(7u, 3u, (((((((_e313 >= 0f) && (_e313 <= _e368)) && (_e328 >= 0f)) && (_e328 <= _e378)) && (_e343 >= 0f)) && (_e343 <= _e388)) && ((((((_e349 >= 0f) && (_e349 <= _e368)) && (_e355 >= 0f)) && (_e355 <= _e378)) && (_e361 >= 0f)) && (_e361 <= _e388)))), 1u, (((_e553 & 64u) != 0u) || ((((select(_e436, _e433, (_e433 > _e436)) <= _e407) && ((select(_e453, _e450, (_e450 > _e453)) > _e407) || (_e547 != 0u))) && true) && ((_e553 & 32u) != 0u))));
} else {
phi_938_ = 7u;
}
let _e563 = phi_938_;
if (_e563 > 1u) {
let _e569 = bitcast<i32>(((_e110 * _e217) + _e108));
let _e572 = (bitcast<i32>(_e92) - 1i);
let _e574 = select(_e572, _e569, (_e569 < _e572));
let _e580 = global_6.member[bitcast<u32>(select(0i, _e574, (_e574 > 0i)))];
let _e581 = (bitcast<i32>(_e222) + _e569);
let _e583 = select(_e572, _e581, (_e581 < _e572));
let _e589 = global_6.member[bitcast<u32>(select(0i, _e583, (_e583 > 0i)))];
let _e591 = f32(bitcast<i32>(_e108));
let _e593 = f32(bitcast<i32>(_e110));
let _e599 = global_1.member.member_5.member;
let _e603 = global_1.member.member_8.member_8;
let _e604 = (_e599 - _e603);
let _e608 = global_1.member.member_8.member_2;
let _e612 = global_1.member.member_8.member_6;
let _e619 = global_1.member.member_8.member_4;
let _e621 = ((_e608 + (_e612 * _e604)) + (((_e591 - _e580) + 0.5f) * _e619));
let _e625 = global_1.member.member_8.member_3;
let _e629 = global_1.member.member_8.member_7;
let _e634 = ((_e625 + (_e629 * _e604)) + (((_e593 - _e589) + 0.5f) * _e619));
let _e638 = global_1.member.member_5.member_1;
let _e639 = (_e638 - _e603);
let _e644 = ((_e608 + (_e612 * _e639)) + ((_e591 + 0.5f) * _e619));
let _e649 = ((_e625 + (_e629 * _e639)) + ((_e593 + 0.5f) * _e619));
let _e653 = global_1.member.member_6.member;
let _e664 = ((((_e653.member.member * _e621) + (_e653.member.member_1 * _e634)) + (_e653.member.member_2 * _e599)) + _e653.member_1);
let _e668 = global_1.member.member_6.member_1;
let _e679 = ((((_e668.member.member * _e621) + (_e668.member.member_1 * _e634)) + (_e668.member.member_2 * _e599)) + _e668.member_1);
let _e683 = global_1.member.member_6.member_2;
let _e694 = ((((_e683.member.member * _e621) + (_e683.member.member_1 * _e634)) + (_e683.member.member_2 * _e599)) + _e683.member_1);
let _e700 = ((((_e653.member.member * _e644) + (_e653.member.member_1 * _e649)) + (_e653.member.member_2 * _e638)) + _e653.member_1);
let _e706 = ((((_e668.member.member * _e644) + (_e668.member.member_1 * _e649)) + (_e668.member.member_2 * _e638)) + _e668.member_1);
let _e712 = ((((_e683.member.member * _e644) + (_e683.member.member_1 * _e649)) + (_e683.member.member_2 * _e638)) + _e683.member_1);
let _e714 = (_e100.member_2 == 2u);
let _e717 = (((_e100.member_2 == 1u) || _e714) || (_e100.member_2 == 5u));
if _e717 {
let _e722 = global_1.member.member_6.member_3.member;
let _e723 = (_e722 - 0.5f);
let _e725 = select(-0.5f, _e700, (_e700 > -0.5f));
let _e727 = select(_e723, _e725, (_e725 < _e723));
let _e732 = global_1.member.member_6.member_3.member_1;
let _e733 = (_e732 - 0.5f);
let _e735 = select(-0.5f, _e706, (_e706 > -0.5f));
let _e737 = select(_e733, _e735, (_e735 < _e733));
let _e742 = global_1.member.member_6.member_3.member_2;
let _e743 = (_e742 - 0.5f);
let _e745 = select(-0.5f, _e712, (_e712 > -0.5f));
let _e747 = select(_e743, _e745, (_e745 < _e743));
let _e749 = select(-1f, _e727, (_e727 > -1f));
let _e751 = select(_e722, _e749, (_e749 < _e722));
let _e758 = select(0i, select(select(i32(_e751), i32(-2147483648), (_e751 < -2147483600f)), 2147483647i, (_e751 > 2147483500f)), (_e751 == _e751));
let _e762 = (_e758 - select(0i, 1i, (_e751 < f32(_e758))));
let _e764 = select(-1f, _e737, (_e737 > -1f));
let _e766 = select(_e732, _e764, (_e764 < _e732));
let _e773 = select(0i, select(select(i32(_e766), i32(-2147483648), (_e766 < -2147483600f)), 2147483647i, (_e766 > 2147483500f)), (_e766 == _e766));
let _e777 = (_e773 - select(0i, 1i, (_e766 < f32(_e773))));
let _e779 = select(-1f, _e747, (_e747 > -1f));
let _e781 = select(_e742, _e779, (_e779 < _e742));
let _e788 = select(0i, select(select(i32(_e781), i32(-2147483648), (_e781 < -2147483600f)), 2147483647i, (_e781 > 2147483500f)), (_e781 == _e781));
let _e792 = (_e788 - select(0i, 1i, (_e781 < f32(_e788))));
let _e796 = global_1.member.member_6.member_7;
let _e800 = global_1.member.member_6.member_8;
let _e808 = (select(0i, select(select(i32(_e732), i32(-2147483648), (_e732 < -2147483600f)), 2147483647i, (_e732 > 2147483500f)), (_e732 == _e732)) - 1i);
let _e809 = (_e777 - 1i);
let _e814 = (_e777 + 1i);
let _e817 = (_e777 + 2i);
let _e827 = (select(0i, select(select(i32(_e742), i32(-2147483648), (_e742 < -2147483600f)), 2147483647i, (_e742 > 2147483500f)), (_e742 == _e742)) - 1i);
let _e828 = (_e792 - 1i);
let _e833 = (_e792 + 1i);
let _e836 = (_e792 + 2i);
let _e846 = (select(0i, select(select(i32(_e722), i32(-2147483648), (_e722 < -2147483600f)), 2147483647i, (_e722 > 2147483500f)), (_e722 == _e722)) - 1i);
let _e847 = (_e762 - 1i);
let _e852 = (_e762 + 1i);
let _e855 = (_e762 + 2i);
let _e858 = (select(0i, _e809, (_e809 > 0i)) * _e796);
let _e859 = (select(0i, _e777, (_e777 > 0i)) * _e796);
let _e860 = (select(_e808, _e814, (_e814 < _e808)) * _e796);
let _e861 = (select(_e808, _e817, (_e817 < _e808)) * _e796);
let _e862 = (select(0i, _e828, (_e828 > 0i)) * _e800);
let _e863 = (select(0i, _e792, (_e792 > 0i)) * _e800);
let _e864 = (select(_e827, _e833, (_e833 < _e827)) * _e800);
let _e865 = (select(_e827, _e836, (_e836 < _e827)) * _e800);
local_4 = type_28(array<i32, 4>(select(0i, _e847, (_e847 > 0i)), select(0i, _e762, (_e762 > 0i)), select(_e846, _e852, (_e852 < _e846)), select(_e846, _e855, (_e855 < _e846))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e727 - f32(_e762)), (_e737 - f32(_e777)), (_e747 - f32(_e792)));
let _e876 = (_e863 + _e859);
let _e879 = local_4.member[0u];
let _e880 = (_e876 + _e879);
let _e882 = (bitcast<i32>(_e86) - 1i);
let _e884 = select(_e882, _e880, (_e880 < _e882));
let _e889 = global_2.member[bitcast<u32>(select(0i, _e884, (_e884 > 0i)))];
let _e890 = bitcast<f32>(_e889);
let _e893 = local_4.member[1u];
let _e894 = (_e876 + _e893);
let _e896 = select(_e882, _e894, (_e894 < _e882));
let _e901 = global_2.member[bitcast<u32>(select(0i, _e896, (_e896 > 0i)))];
let _e902 = bitcast<f32>(_e901);
let _e905 = local_4.member[2u];
let _e906 = (_e876 + _e905);
let _e908 = select(_e882, _e906, (_e906 < _e882));
let _e913 = global_2.member[bitcast<u32>(select(0i, _e908, (_e908 > 0i)))];
let _e914 = bitcast<f32>(_e913);
let _e917 = local_4.member[3u];
let _e918 = (_e876 + _e917);
let _e920 = select(_e882, _e918, (_e918 < _e882));
let _e925 = global_2.member[bitcast<u32>(select(0i, _e920, (_e920 > 0i)))];
let _e927 = local_5[0u];
let _e930 = (_e890 + ((_e902 - _e890) * _e927));
let _e931 = local_5[0u];
let _e934 = (_e902 + ((_e914 - _e902) * _e931));
let _e935 = local_5[0u];
let _e938 = (_e914 + ((bitcast<f32>(_e925) - _e914) * _e935));
let _e939 = (_e863 + _e860);
let _e940 = local_4.member[0u];
let _e941 = (_e939 + _e940);
let _e943 = select(_e882, _e941, (_e941 < _e882));
let _e948 = global_2.member[bitcast<u32>(select(0i, _e943, (_e943 > 0i)))];
let _e949 = bitcast<f32>(_e948);
let _e950 = local_4.member[1u];
let _e951 = (_e939 + _e950);
let _e953 = select(_e882, _e951, (_e951 < _e882));
let _e958 = global_2.member[bitcast<u32>(select(0i, _e953, (_e953 > 0i)))];
let _e959 = bitcast<f32>(_e958);
let _e960 = local_4.member[2u];
let _e961 = (_e939 + _e960);
let _e963 = select(_e882, _e961, (_e961 < _e882));
let _e968 = global_2.member[bitcast<u32>(select(0i, _e963, (_e963 > 0i)))];
let _e969 = bitcast<f32>(_e968);
let _e970 = local_4.member[3u];
let _e971 = (_e939 + _e970);
let _e973 = select(_e882, _e971, (_e971 < _e882));
let _e978 = global_2.member[bitcast<u32>(select(0i, _e973, (_e973 > 0i)))];
let _e980 = local_5[0u];
let _e984 = local_5[0u];
let _e987 = (_e959 + ((_e969 - _e959) * _e984));
let _e988 = local_5[0u];
let _e992 = (_e864 + _e859);
let _e993 = local_4.member[0u];
let _e994 = (_e992 + _e993);
let _e996 = select(_e882, _e994, (_e994 < _e882));
let _e1001 = global_2.member[bitcast<u32>(select(0i, _e996, (_e996 > 0i)))];
let _e1002 = bitcast<f32>(_e1001);
let _e1003 = local_4.member[1u];
let _e1004 = (_e992 + _e1003);
let _e1006 = select(_e882, _e1004, (_e1004 < _e882));
let _e1011 = global_2.member[bitcast<u32>(select(0i, _e1006, (_e1006 > 0i)))];
let _e1012 = bitcast<f32>(_e1011);
let _e1013 = local_4.member[2u];
let _e1014 = (_e992 + _e1013);
let _e1016 = select(_e882, _e1014, (_e1014 < _e882));
let _e1021 = global_2.member[bitcast<u32>(select(0i, _e1016, (_e1016 > 0i)))];
let _e1022 = bitcast<f32>(_e1021);
let _e1023 = local_4.member[3u];
let _e1024 = (_e992 + _e1023);
let _e1026 = select(_e882, _e1024, (_e1024 < _e882));
let _e1031 = global_2.member[bitcast<u32>(select(0i, _e1026, (_e1026 > 0i)))];
let _e1033 = local_5[0u];
let _e1036 = (_e1002 + ((_e1012 - _e1002) * _e1033));
let _e1037 = local_5[0u];
let _e1040 = (_e1012 + ((_e1022 - _e1012) * _e1037));
let _e1041 = local_5[0u];
let _e1044 = (_e1022 + ((bitcast<f32>(_e1031) - _e1022) * _e1041));
let _e1045 = (_e864 + _e860);
let _e1046 = local_4.member[0u];
let _e1047 = (_e1045 + _e1046);
let _e1049 = select(_e882, _e1047, (_e1047 < _e882));
let _e1054 = global_2.member[bitcast<u32>(select(0i, _e1049, (_e1049 > 0i)))];
let _e1055 = bitcast<f32>(_e1054);
let _e1056 = local_4.member[1u];
let _e1057 = (_e1045 + _e1056);
let _e1059 = select(_e882, _e1057, (_e1057 < _e882));
let _e1064 = global_2.member[bitcast<u32>(select(0i, _e1059, (_e1059 > 0i)))];
let _e1065 = bitcast<f32>(_e1064);
let _e1066 = local_4.member[2u];
let _e1067 = (_e1045 + _e1066);
let _e1069 = select(_e882, _e1067, (_e1067 < _e882));
let _e1074 = global_2.member[bitcast<u32>(select(0i, _e1069, (_e1069 > 0i)))];
let _e1075 = bitcast<f32>(_e1074);
let _e1076 = local_4.member[3u];
let _e1077 = (_e1045 + _e1076);
let _e1079 = select(_e882, _e1077, (_e1077 < _e882));
let _e1084 = global_2.member[bitcast<u32>(select(0i, _e1079, (_e1079 > 0i)))];
let _e1086 = local_5[0u];
let _e1090 = local_5[0u];
let _e1093 = (_e1065 + ((_e1075 - _e1065) * _e1090));
let _e1094 = local_5[0u];
let _e1098 = (_e863 + _e858);
let _e1099 = local_4.member[1u];
let _e1100 = (_e1098 + _e1099);
let _e1102 = select(_e882, _e1100, (_e1100 < _e882));
let _e1107 = global_2.member[bitcast<u32>(select(0i, _e1102, (_e1102 > 0i)))];
let _e1108 = bitcast<f32>(_e1107);
let _e1109 = local_4.member[2u];
let _e1110 = (_e1098 + _e1109);
let _e1112 = select(_e882, _e1110, (_e1110 < _e882));
let _e1117 = global_2.member[bitcast<u32>(select(0i, _e1112, (_e1112 > 0i)))];
let _e1119 = local_5[0u];
let _e1122 = (_e1108 + ((bitcast<f32>(_e1117) - _e1108) * _e1119));
let _e1123 = (_e863 + _e861);
let _e1124 = local_4.member[1u];
let _e1125 = (_e1123 + _e1124);
let _e1127 = select(_e882, _e1125, (_e1125 < _e882));
let _e1132 = global_2.member[bitcast<u32>(select(0i, _e1127, (_e1127 > 0i)))];
let _e1133 = bitcast<f32>(_e1132);
let _e1134 = local_4.member[2u];
let _e1135 = (_e1123 + _e1134);
let _e1137 = select(_e882, _e1135, (_e1135 < _e882));
let _e1142 = global_2.member[bitcast<u32>(select(0i, _e1137, (_e1137 > 0i)))];
let _e1144 = local_5[0u];
let _e1148 = (_e864 + _e858);
let _e1149 = local_4.member[1u];
let _e1150 = (_e1148 + _e1149);
let _e1152 = select(_e882, _e1150, (_e1150 < _e882));
let _e1157 = global_2.member[bitcast<u32>(select(0i, _e1152, (_e1152 > 0i)))];
let _e1158 = bitcast<f32>(_e1157);
let _e1159 = local_4.member[2u];
let _e1160 = (_e1148 + _e1159);
let _e1162 = select(_e882, _e1160, (_e1160 < _e882));
let _e1167 = global_2.member[bitcast<u32>(select(0i, _e1162, (_e1162 > 0i)))];
let _e1169 = local_5[0u];
let _e1172 = (_e1158 + ((bitcast<f32>(_e1167) - _e1158) * _e1169));
let _e1173 = (_e864 + _e861);
let _e1174 = local_4.member[1u];
let _e1175 = (_e1173 + _e1174);
let _e1177 = select(_e882, _e1175, (_e1175 < _e882));
let _e1182 = global_2.member[bitcast<u32>(select(0i, _e1177, (_e1177 > 0i)))];
let _e1183 = bitcast<f32>(_e1182);
let _e1184 = local_4.member[2u];
let _e1185 = (_e1173 + _e1184);
let _e1187 = select(_e882, _e1185, (_e1185 < _e882));
let _e1192 = global_2.member[bitcast<u32>(select(0i, _e1187, (_e1187 > 0i)))];
let _e1194 = local_5[0u];
let _e1198 = (_e862 + _e859);
let _e1199 = local_4.member[1u];
let _e1200 = (_e1198 + _e1199);
let _e1202 = select(_e882, _e1200, (_e1200 < _e882));
let _e1207 = global_2.member[bitcast<u32>(select(0i, _e1202, (_e1202 > 0i)))];
let _e1208 = bitcast<f32>(_e1207);
let _e1209 = local_4.member[2u];
let _e1210 = (_e1198 + _e1209);
let _e1212 = select(_e882, _e1210, (_e1210 < _e882));
let _e1217 = global_2.member[bitcast<u32>(select(0i, _e1212, (_e1212 > 0i)))];
let _e1219 = local_5[0u];
let _e1222 = (_e1208 + ((bitcast<f32>(_e1217) - _e1208) * _e1219));
let _e1223 = (_e865 + _e859);
let _e1224 = local_4.member[1u];
let _e1225 = (_e1223 + _e1224);
let _e1227 = select(_e882, _e1225, (_e1225 < _e882));
let _e1232 = global_2.member[bitcast<u32>(select(0i, _e1227, (_e1227 > 0i)))];
let _e1233 = bitcast<f32>(_e1232);
let _e1234 = local_4.member[2u];
let _e1235 = (_e1223 + _e1234);
let _e1237 = select(_e882, _e1235, (_e1235 < _e882));
let _e1242 = global_2.member[bitcast<u32>(select(0i, _e1237, (_e1237 > 0i)))];
let _e1244 = local_5[0u];
let _e1247 = (_e1233 + ((bitcast<f32>(_e1242) - _e1233) * _e1244));
let _e1248 = (_e862 + _e860);
let _e1249 = local_4.member[1u];
let _e1250 = (_e1248 + _e1249);
let _e1252 = select(_e882, _e1250, (_e1250 < _e882));
let _e1257 = global_2.member[bitcast<u32>(select(0i, _e1252, (_e1252 > 0i)))];
let _e1258 = bitcast<f32>(_e1257);
let _e1259 = local_4.member[2u];
let _e1260 = (_e1248 + _e1259);
let _e1262 = select(_e882, _e1260, (_e1260 < _e882));
let _e1267 = global_2.member[bitcast<u32>(select(0i, _e1262, (_e1262 > 0i)))];
let _e1269 = local_5[0u];
let _e1273 = (_e865 + _e860);
let _e1274 = local_4.member[1u];
let _e1275 = (_e1273 + _e1274);
let _e1277 = select(_e882, _e1275, (_e1275 < _e882));
let _e1282 = global_2.member[bitcast<u32>(select(0i, _e1277, (_e1277 > 0i)))];
let _e1283 = bitcast<f32>(_e1282);
let _e1284 = local_4.member[2u];
let _e1285 = (_e1273 + _e1284);
let _e1287 = select(_e882, _e1285, (_e1285 < _e882));
let _e1292 = global_2.member[bitcast<u32>(select(0i, _e1287, (_e1287 > 0i)))];
let _e1294 = local_5[0u];
let _e1299 = local_5[1u];
let _e1302 = (_e934 + ((_e987 - _e934) * _e1299));
let _e1303 = local_5[1u];
let _e1306 = (_e1040 + ((_e1093 - _e1040) * _e1303));
let _e1307 = local_5[1u];
let _e1310 = (_e930 + (((_e949 + ((_e959 - _e949) * _e980)) - _e930) * _e1307));
let _e1311 = local_5[1u];
let _e1316 = local_5[2u];
let _e1320 = local_5[1u];
let _e1323 = (_e938 + (((_e969 + ((bitcast<f32>(_e978) - _e969) * _e988)) - _e938) * _e1320));
let _e1324 = local_5[1u];
let _e1328 = local_5[2u];
let _e1332 = local_5[1u];
let _e1335 = (_e1122 + ((_e934 - _e1122) * _e1332));
let _e1336 = local_5[1u];
let _e1340 = local_5[2u];
let _e1344 = local_5[1u];
let _e1347 = (_e987 + (((_e1133 + ((bitcast<f32>(_e1142) - _e1133) * _e1144)) - _e987) * _e1344));
let _e1348 = local_5[1u];
let _e1352 = local_5[2u];
let _e1356 = local_5[1u];
let _e1359 = (_e1222 + (((_e1258 + ((bitcast<f32>(_e1267) - _e1258) * _e1269)) - _e1222) * _e1356));
let _e1360 = local_5[2u];
let _e1364 = local_5[1u];
let _e1368 = local_5[2u];
let _e1372 = local_5[2u];
let _e1379 = global_1.member.member_6.member_5;
let _e1384 = global_1.member.member_6.member_6;
let _e1385 = (((_e1302 + ((_e1306 - _e1302) * _e1372)) * _e1379) + _e1384);
let _e1387 = select(0f, _e1385, (_e1385 > 0f));
let _e1389 = select(1f, _e1387, (_e1387 < 1f));
let _e1391 = (((_e1310 + (((_e1036 + (((_e1055 + ((_e1065 - _e1055) * _e1086)) - _e1036) * _e1311)) - _e1310) * _e1316)) * _e1379) + _e1384);
let _e1393 = select(0f, _e1391, (_e1391 > 0f));
let _e1395 = select(1f, _e1393, (_e1393 < 1f));
let _e1397 = (((_e1323 + (((_e1044 + (((_e1075 + ((bitcast<f32>(_e1084) - _e1075) * _e1094)) - _e1044) * _e1324)) - _e1323) * _e1328)) * _e1379) + _e1384);
let _e1399 = select(0f, _e1397, (_e1397 > 0f));
let _e1401 = select(1f, _e1399, (_e1399 < 1f));
let _e1403 = (((_e1335 + (((_e1172 + ((_e1040 - _e1172) * _e1336)) - _e1335) * _e1340)) * _e1379) + _e1384);
let _e1405 = select(0f, _e1403, (_e1403 > 0f));
let _e1407 = select(1f, _e1405, (_e1405 < 1f));
let _e1409 = (((_e1347 + (((_e1093 + (((_e1183 + ((bitcast<f32>(_e1192) - _e1183) * _e1194)) - _e1093) * _e1348)) - _e1347) * _e1352)) * _e1379) + _e1384);
let _e1411 = select(0f, _e1409, (_e1409 > 0f));
let _e1413 = select(1f, _e1411, (_e1411 < 1f));
let _e1415 = (((_e1359 + ((_e1302 - _e1359) * _e1360)) * _e1379) + _e1384);
let _e1417 = select(0f, _e1415, (_e1415 > 0f));
let _e1419 = select(1f, _e1417, (_e1417 < 1f));
let _e1421 = (((_e1306 + (((_e1247 + (((_e1283 + ((bitcast<f32>(_e1292) - _e1283) * _e1294)) - _e1247) * _e1364)) - _e1306) * _e1368)) * _e1379) + _e1384);
let _e1423 = select(0f, _e1421, (_e1421 > 0f));
let _e1425 = select(1f, _e1423, (_e1423 < 1f));
let _e1426 = (_e1389 * 1024f);
let _e1427 = (1024f - 1f);
let _e1429 = select(0f, _e1426, (_e1426 > 0f));
let _e1431 = select(_e1427, _e1429, (_e1429 < _e1427));
let _e1438 = select(0i, select(select(i32(_e1431), i32(-2147483648), (_e1431 < -2147483600f)), 2147483647i, (_e1431 > 2147483500f)), (_e1431 == _e1431));
let _e1442 = (_e1438 - select(0i, 1i, (_e1431 < f32(_e1438))));
let _e1443 = (262147i + _e1442);
let _e1445 = (bitcast<i32>(_e90) - 1i);
let _e1447 = select(_e1445, _e1443, (_e1443 < _e1445));
let _e1453 = global_4.member[bitcast<u32>(select(0i, _e1447, (_e1447 > 0i)))];
let _e1463 = select(_e1445, 262146i, (262146i < _e1445));
let _e1469 = global_4.member[bitcast<u32>(select(0i, _e1463, (_e1463 > 0i)))];
let _e1470 = bitcast<f32>(_e1469);
let _e1471 = (f32((bitcast<i32>((_e1453 & 4095u)) - 2048i)) * _e1470);
let _e1473 = select(_e1445, 262144i, (262144i < _e1445));
let _e1479 = global_4.member[bitcast<u32>(select(0i, _e1473, (_e1473 > 0i)))];
let _e1480 = bitcast<f32>(_e1479);
let _e1482 = select(_e1445, 262145i, (262145i < _e1445));
let _e1488 = global_4.member[bitcast<u32>(select(0i, _e1482, (_e1482 > 0i)))];
let _e1489 = bitcast<f32>(_e1488);
let _e1495 = ((_e1480 + (f32(bitcast<i32>((_e1453 >> bitcast<u32>(12u)))) * _e1489)) + (_e1471 * (_e1426 - f32(_e1442))));
let _e1496 = (_e1471 * 1024f);
if _e714 {
let _e1503 = ((0.5f * (_e1401 - _e1395)) * _e1496);
let _e1504 = ((0.5f * (_e1413 - _e1407)) * _e1496);
let _e1505 = ((0.5f * (_e1425 - _e1419)) * _e1496);
phi_3193_ = type_29(_e1495, vec3<f32>(_e1503, _e1504, _e1505), vec3<f32>((_e1503 * _e1495), (_e1504 * _e1495), (_e1505 * _e1495)));
} else {
let _e1512 = (_e1395 * 1024f);
let _e1514 = select(0f, _e1512, (_e1512 > 0f));
let _e1516 = select(_e1427, _e1514, (_e1514 < _e1427));
let _e1523 = select(0i, select(select(i32(_e1516), i32(-2147483648), (_e1516 < -2147483600f)), 2147483647i, (_e1516 > 2147483500f)), (_e1516 == _e1516));
let _e1527 = (_e1523 - select(0i, 1i, (_e1516 < f32(_e1523))));
let _e1528 = (262147i + _e1527);
let _e1530 = select(_e1445, _e1528, (_e1528 < _e1445));
let _e1536 = global_4.member[bitcast<u32>(select(0i, _e1530, (_e1530 > 0i)))];
let _e1551 = ((_e1480 + (f32(bitcast<i32>((_e1536 >> bitcast<u32>(12u)))) * _e1489)) + ((f32((bitcast<i32>((_e1536 & 4095u)) - 2048i)) * _e1470) * (_e1512 - f32(_e1527))));
let _e1552 = (_e1401 * 1024f);
let _e1554 = select(0f, _e1552, (_e1552 > 0f));
let _e1556 = select(_e1427, _e1554, (_e1554 < _e1427));
let _e1563 = select(0i, select(select(i32(_e1556), i32(-2147483648), (_e1556 < -2147483600f)), 2147483647i, (_e1556 > 2147483500f)), (_e1556 == _e1556));
let _e1567 = (_e1563 - select(0i, 1i, (_e1556 < f32(_e1563))));
let _e1568 = (262147i + _e1567);
let _e1570 = select(_e1445, _e1568, (_e1568 < _e1445));
let _e1576 = global_4.member[bitcast<u32>(select(0i, _e1570, (_e1570 > 0i)))];
let _e1591 = ((_e1480 + (f32(bitcast<i32>((_e1576 >> bitcast<u32>(12u)))) * _e1489)) + ((f32((bitcast<i32>((_e1576 & 4095u)) - 2048i)) * _e1470) * (_e1552 - f32(_e1567))));
let _e1592 = (_e1407 * 1024f);
let _e1594 = select(0f, _e1592, (_e1592 > 0f));
let _e1596 = select(_e1427, _e1594, (_e1594 < _e1427));
let _e1603 = select(0i, select(select(i32(_e1596), i32(-2147483648), (_e1596 < -2147483600f)), 2147483647i, (_e1596 > 2147483500f)), (_e1596 == _e1596));
let _e1607 = (_e1603 - select(0i, 1i, (_e1596 < f32(_e1603))));
let _e1608 = (262147i + _e1607);
let _e1610 = select(_e1445, _e1608, (_e1608 < _e1445));
let _e1616 = global_4.member[bitcast<u32>(select(0i, _e1610, (_e1610 > 0i)))];
let _e1631 = ((_e1480 + (f32(bitcast<i32>((_e1616 >> bitcast<u32>(12u)))) * _e1489)) + ((f32((bitcast<i32>((_e1616 & 4095u)) - 2048i)) * _e1470) * (_e1592 - f32(_e1607))));
let _e1632 = (_e1413 * 1024f);
let _e1634 = select(0f, _e1632, (_e1632 > 0f));
let _e1636 = select(_e1427, _e1634, (_e1634 < _e1427));
let _e1643 = select(0i, select(select(i32(_e1636), i32(-2147483648), (_e1636 < -2147483600f)), 2147483647i, (_e1636 > 2147483500f)), (_e1636 == _e1636));
let _e1647 = (_e1643 - select(0i, 1i, (_e1636 < f32(_e1643))));
let _e1648 = (262147i + _e1647);
let _e1650 = select(_e1445, _e1648, (_e1648 < _e1445));
let _e1656 = global_4.member[bitcast<u32>(select(0i, _e1650, (_e1650 > 0i)))];
let _e1671 = ((_e1480 + (f32(bitcast<i32>((_e1656 >> bitcast<u32>(12u)))) * _e1489)) + ((f32((bitcast<i32>((_e1656 & 4095u)) - 2048i)) * _e1470) * (_e1632 - f32(_e1647))));
let _e1672 = (_e1419 * 1024f);
let _e1674 = select(0f, _e1672, (_e1672 > 0f));
let _e1676 = select(_e1427, _e1674, (_e1674 < _e1427));
let _e1683 = select(0i, select(select(i32(_e1676), i32(-2147483648), (_e1676 < -2147483600f)), 2147483647i, (_e1676 > 2147483500f)), (_e1676 == _e1676));
let _e1687 = (_e1683 - select(0i, 1i, (_e1676 < f32(_e1683))));
let _e1688 = (262147i + _e1687);
let _e1690 = select(_e1445, _e1688, (_e1688 < _e1445));
let _e1696 = global_4.member[bitcast<u32>(select(0i, _e1690, (_e1690 > 0i)))];
let _e1711 = ((_e1480 + (f32(bitcast<i32>((_e1696 >> bitcast<u32>(12u)))) * _e1489)) + ((f32((bitcast<i32>((_e1696 & 4095u)) - 2048i)) * _e1470) * (_e1672 - f32(_e1687))));
let _e1712 = (_e1425 * 1024f);
let _e1714 = select(0f, _e1712, (_e1712 > 0f));
let _e1716 = select(_e1427, _e1714, (_e1714 < _e1427));
let _e1723 = select(0i, select(select(i32(_e1716), i32(-2147483648), (_e1716 < -2147483600f)), 2147483647i, (_e1716 > 2147483500f)), (_e1716 == _e1716));
let _e1727 = (_e1723 - select(0i, 1i, (_e1716 < f32(_e1723))));
let _e1728 = (262147i + _e1727);
let _e1730 = select(_e1445, _e1728, (_e1728 < _e1445));
let _e1736 = global_4.member[bitcast<u32>(select(0i, _e1730, (_e1730 > 0i)))];
let _e1751 = ((_e1480 + (f32(bitcast<i32>((_e1736 >> bitcast<u32>(12u)))) * _e1489)) + ((f32((bitcast<i32>((_e1736 & 4095u)) - 2048i)) * _e1470) * (_e1712 - f32(_e1727))));
let _e1752 = (_e1591 - _e1551);
let _e1754 = (_e1671 - _e1631);
let _e1756 = (_e1751 - _e1711);
phi_3193_ = type_29(_e1495, vec3<f32>((0.5f * _e1752), (0.5f * _e1754), (0.5f * _e1756)), vec3<f32>((0.25f * (_e1752 * (_e1591 + _e1551))), (0.25f * (_e1754 * (_e1671 + _e1631))), (0.25f * (_e1756 * (_e1751 + _e1711)))));
}
let _e1771 = phi_3193_;
let _e1786 = select(0f, 1f, ((((((_e700 >= -0.5f) && (_e700 <= _e723)) && (_e706 >= -0.5f)) && (_e706 <= _e733)) && (_e712 >= -0.5f)) && (_e712 <= _e743)));
let _e1788 = (0.5f * (_e1401 - _e1395));
let _e1790 = (0.5f * (_e1413 - _e1407));
let _e1792 = (0.5f * (_e1425 - _e1419));
let _e1798 = global_1.member.member_6.member.member.member;
let _e1804 = global_1.member.member_6.member.member.member_1;
let _e1810 = global_1.member.member_6.member.member.member_2;
let _e1816 = global_1.member.member_6.member_1.member.member;
let _e1822 = global_1.member.member_6.member_1.member.member_1;
let _e1828 = global_1.member.member_6.member_1.member.member_2;
let _e1834 = global_1.member.member_6.member_2.member.member;
let _e1840 = global_1.member.member_6.member_2.member.member_1;
let _e1846 = global_1.member.member_6.member_2.member.member_2;
phi_3839_ = type_30(_e1389, vec3<f32>(((((_e1798 * _e1788) + (_e1816 * _e1790)) + (_e1834 * _e1792)) * _e1786), ((((_e1804 * _e1788) + (_e1822 * _e1790)) + (_e1840 * _e1792)) * _e1786), ((((_e1810 * _e1788) + (_e1828 * _e1790)) + (_e1846 * _e1792)) * _e1786)), _e1771.member, vec3<f32>(((((_e1798 * _e1771.member_2.x) + (_e1816 * _e1771.member_2.y)) + (_e1834 * _e1771.member_2.z)) * _e1786), ((((_e1804 * _e1771.member_2.x) + (_e1822 * _e1771.member_2.y)) + (_e1840 * _e1771.member_2.z)) * _e1786), ((((_e1810 * _e1771.member_2.x) + (_e1828 * _e1771.member_2.y)) + (_e1846 * _e1771.member_2.z)) * _e1786)), vec3<f32>(((((_e1798 * _e1771.member_1.x) + (_e1816 * _e1771.member_1.y)) + (_e1834 * _e1771.member_1.z)) * _e1786), ((((_e1804 * _e1771.member_1.x) + (_e1822 * _e1771.member_1.y)) + (_e1840 * _e1771.member_1.z)) * _e1786), ((((_e1810 * _e1771.member_1.x) + (_e1828 * _e1771.member_1.y)) + (_e1846 * _e1771.member_1.z)) * _e1786)));
} else {
let _e1915 = global_1.member.member_6.member_3.member;
let _e1916 = (_e1915 - 0.5f);
let _e1918 = select(-0.5f, _e700, (_e700 > -0.5f));
let _e1920 = select(_e1916, _e1918, (_e1918 < _e1916));
let _e1925 = global_1.member.member_6.member_3.member_1;
let _e1926 = (_e1925 - 0.5f);
let _e1928 = select(-0.5f, _e706, (_e706 > -0.5f));
let _e1930 = select(_e1926, _e1928, (_e1928 < _e1926));
let _e1935 = global_1.member.member_6.member_3.member_2;
let _e1936 = (_e1935 - 0.5f);
let _e1938 = select(-0.5f, _e712, (_e712 > -0.5f));
let _e1940 = select(_e1936, _e1938, (_e1938 < _e1936));
let _e1942 = select(-1f, _e1920, (_e1920 > -1f));
let _e1944 = select(_e1915, _e1942, (_e1942 < _e1915));
let _e1951 = select(0i, select(select(i32(_e1944), i32(-2147483648), (_e1944 < -2147483600f)), 2147483647i, (_e1944 > 2147483500f)), (_e1944 == _e1944));
let _e1955 = (_e1951 - select(0i, 1i, (_e1944 < f32(_e1951))));
let _e1957 = select(-1f, _e1930, (_e1930 > -1f));
let _e1959 = select(_e1925, _e1957, (_e1957 < _e1925));
let _e1966 = select(0i, select(select(i32(_e1959), i32(-2147483648), (_e1959 < -2147483600f)), 2147483647i, (_e1959 > 2147483500f)), (_e1959 == _e1959));
let _e1970 = (_e1966 - select(0i, 1i, (_e1959 < f32(_e1966))));
let _e1972 = select(-1f, _e1940, (_e1940 > -1f));
let _e1974 = select(_e1935, _e1972, (_e1972 < _e1935));
let _e1981 = select(0i, select(select(i32(_e1974), i32(-2147483648), (_e1974 < -2147483600f)), 2147483647i, (_e1974 > 2147483500f)), (_e1974 == _e1974));
let _e1985 = (_e1981 - select(0i, 1i, (_e1974 < f32(_e1981))));
let _e1989 = global_1.member.member_6.member_7;
let _e1993 = global_1.member.member_6.member_8;
let _e2001 = (select(0i, select(select(i32(_e1925), i32(-2147483648), (_e1925 < -2147483600f)), 2147483647i, (_e1925 > 2147483500f)), (_e1925 == _e1925)) - 1i);
let _e2004 = (_e1970 + 1i);
let _e2014 = (select(0i, select(select(i32(_e1935), i32(-2147483648), (_e1935 < -2147483600f)), 2147483647i, (_e1935 > 2147483500f)), (_e1935 == _e1935)) - 1i);
let _e2017 = (_e1985 + 1i);
let _e2027 = (select(0i, select(select(i32(_e1915), i32(-2147483648), (_e1915 < -2147483600f)), 2147483647i, (_e1915 > 2147483500f)), (_e1915 == _e1915)) - 1i);
let _e2028 = (_e1955 - 1i);
let _e2033 = (_e1955 + 1i);
let _e2036 = (_e1955 + 2i);
let _e2039 = (select(0i, _e1970, (_e1970 > 0i)) * _e1989);
let _e2040 = (select(_e2001, _e2004, (_e2004 < _e2001)) * _e1989);
let _e2041 = (select(0i, _e1985, (_e1985 > 0i)) * _e1993);
let _e2042 = (select(_e2014, _e2017, (_e2017 < _e2014)) * _e1993);
local_2 = type_28(array<i32, 4>(select(0i, _e2028, (_e2028 > 0i)), select(0i, _e1955, (_e1955 > 0i)), select(_e2027, _e2033, (_e2033 < _e2027)), select(_e2027, _e2036, (_e2036 < _e2027))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e1920 - f32(_e1955)), (_e1930 - f32(_e1970)), (_e1940 - f32(_e1985)));
let _e2053 = (_e2041 + _e2039);
let _e2056 = local_2.member[1u];
let _e2057 = (_e2053 + _e2056);
let _e2059 = (bitcast<i32>(_e86) - 1i);
let _e2061 = select(_e2059, _e2057, (_e2057 < _e2059));
let _e2066 = global_2.member[bitcast<u32>(select(0i, _e2061, (_e2061 > 0i)))];
let _e2067 = bitcast<f32>(_e2066);
let _e2070 = local_2.member[2u];
let _e2071 = (_e2053 + _e2070);
let _e2073 = select(_e2059, _e2071, (_e2071 < _e2059));
let _e2078 = global_2.member[bitcast<u32>(select(0i, _e2073, (_e2073 > 0i)))];
let _e2080 = local_3[0u];
let _e2083 = (_e2067 + ((bitcast<f32>(_e2078) - _e2067) * _e2080));
let _e2084 = (_e2041 + _e2040);
let _e2085 = local_2.member[1u];
let _e2086 = (_e2084 + _e2085);
let _e2088 = select(_e2059, _e2086, (_e2086 < _e2059));
let _e2093 = global_2.member[bitcast<u32>(select(0i, _e2088, (_e2088 > 0i)))];
let _e2094 = bitcast<f32>(_e2093);
let _e2095 = local_2.member[2u];
let _e2096 = (_e2084 + _e2095);
let _e2098 = select(_e2059, _e2096, (_e2096 < _e2059));
let _e2103 = global_2.member[bitcast<u32>(select(0i, _e2098, (_e2098 > 0i)))];
let _e2105 = local_3[0u];
let _e2110 = local_3[1u];
let _e2113 = (_e2083 + (((_e2094 + ((bitcast<f32>(_e2103) - _e2094) * _e2105)) - _e2083) * _e2110));
let _e2114 = (_e2042 + _e2039);
let _e2115 = local_2.member[1u];
let _e2116 = (_e2114 + _e2115);
let _e2118 = select(_e2059, _e2116, (_e2116 < _e2059));
let _e2123 = global_2.member[bitcast<u32>(select(0i, _e2118, (_e2118 > 0i)))];
let _e2124 = bitcast<f32>(_e2123);
let _e2125 = local_2.member[2u];
let _e2126 = (_e2114 + _e2125);
let _e2128 = select(_e2059, _e2126, (_e2126 < _e2059));
let _e2133 = global_2.member[bitcast<u32>(select(0i, _e2128, (_e2128 > 0i)))];
let _e2135 = local_3[0u];
let _e2138 = (_e2124 + ((bitcast<f32>(_e2133) - _e2124) * _e2135));
let _e2139 = (_e2042 + _e2040);
let _e2140 = local_2.member[1u];
let _e2141 = (_e2139 + _e2140);
let _e2143 = select(_e2059, _e2141, (_e2141 < _e2059));
let _e2148 = global_2.member[bitcast<u32>(select(0i, _e2143, (_e2143 > 0i)))];
let _e2149 = bitcast<f32>(_e2148);
let _e2150 = local_2.member[2u];
let _e2151 = (_e2139 + _e2150);
let _e2153 = select(_e2059, _e2151, (_e2151 < _e2059));
let _e2158 = global_2.member[bitcast<u32>(select(0i, _e2153, (_e2153 > 0i)))];
let _e2160 = local_3[0u];
let _e2164 = local_3[1u];
let _e2169 = local_3[2u];
let _e2176 = global_1.member.member_6.member_5;
let _e2181 = global_1.member.member_6.member_6;
let _e2182 = (((_e2113 + (((_e2138 + (((_e2149 + ((bitcast<f32>(_e2158) - _e2149) * _e2160)) - _e2138) * _e2164)) - _e2113) * _e2169)) * _e2176) + _e2181);
let _e2184 = select(0f, _e2182, (_e2182 > 0f));
phi_3839_ = type_30(select(1f, _e2184, (_e2184 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2189 = phi_3839_;
let _e2194 = global_1.member.member_6.member_3.member;
let _e2195 = (_e2194 - 0.5f);
let _e2197 = select(-0.5f, _e664, (_e664 > -0.5f));
let _e2199 = select(_e2195, _e2197, (_e2197 < _e2195));
let _e2204 = global_1.member.member_6.member_3.member_1;
let _e2205 = (_e2204 - 0.5f);
let _e2207 = select(-0.5f, _e679, (_e679 > -0.5f));
let _e2209 = select(_e2205, _e2207, (_e2207 < _e2205));
let _e2214 = global_1.member.member_6.member_3.member_2;
let _e2215 = (_e2214 - 0.5f);
let _e2217 = select(-0.5f, _e694, (_e694 > -0.5f));
let _e2219 = select(_e2215, _e2217, (_e2217 < _e2215));
let _e2221 = select(-1f, _e2199, (_e2199 > -1f));
let _e2223 = select(_e2194, _e2221, (_e2221 < _e2194));
let _e2230 = select(0i, select(select(i32(_e2223), i32(-2147483648), (_e2223 < -2147483600f)), 2147483647i, (_e2223 > 2147483500f)), (_e2223 == _e2223));
let _e2234 = (_e2230 - select(0i, 1i, (_e2223 < f32(_e2230))));
let _e2236 = select(-1f, _e2209, (_e2209 > -1f));
let _e2238 = select(_e2204, _e2236, (_e2236 < _e2204));
let _e2245 = select(0i, select(select(i32(_e2238), i32(-2147483648), (_e2238 < -2147483600f)), 2147483647i, (_e2238 > 2147483500f)), (_e2238 == _e2238));
let _e2249 = (_e2245 - select(0i, 1i, (_e2238 < f32(_e2245))));
let _e2251 = select(-1f, _e2219, (_e2219 > -1f));
let _e2253 = select(_e2214, _e2251, (_e2251 < _e2214));
let _e2260 = select(0i, select(select(i32(_e2253), i32(-2147483648), (_e2253 < -2147483600f)), 2147483647i, (_e2253 > 2147483500f)), (_e2253 == _e2253));
let _e2264 = (_e2260 - select(0i, 1i, (_e2253 < f32(_e2260))));
let _e2268 = global_1.member.member_6.member_7;
let _e2272 = global_1.member.member_6.member_8;
let _e2280 = (select(0i, select(select(i32(_e2204), i32(-2147483648), (_e2204 < -2147483600f)), 2147483647i, (_e2204 > 2147483500f)), (_e2204 == _e2204)) - 1i);
let _e2283 = (_e2249 + 1i);
let _e2293 = (select(0i, select(select(i32(_e2214), i32(-2147483648), (_e2214 < -2147483600f)), 2147483647i, (_e2214 > 2147483500f)), (_e2214 == _e2214)) - 1i);
let _e2296 = (_e2264 + 1i);
let _e2306 = (select(0i, select(select(i32(_e2194), i32(-2147483648), (_e2194 < -2147483600f)), 2147483647i, (_e2194 > 2147483500f)), (_e2194 == _e2194)) - 1i);
let _e2307 = (_e2234 - 1i);
let _e2312 = (_e2234 + 1i);
let _e2315 = (_e2234 + 2i);
let _e2318 = (select(0i, _e2249, (_e2249 > 0i)) * _e2268);
let _e2319 = (select(_e2280, _e2283, (_e2283 < _e2280)) * _e2268);
let _e2320 = (select(0i, _e2264, (_e2264 > 0i)) * _e2272);
let _e2321 = (select(_e2293, _e2296, (_e2296 < _e2293)) * _e2272);
local = type_28(array<i32, 4>(select(0i, _e2307, (_e2307 > 0i)), select(0i, _e2234, (_e2234 > 0i)), select(_e2306, _e2312, (_e2312 < _e2306)), select(_e2306, _e2315, (_e2315 < _e2306))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_1 = vec3<f32>((_e2199 - f32(_e2234)), (_e2209 - f32(_e2249)), (_e2219 - f32(_e2264)));
let _e2332 = (_e2320 + _e2318);
let _e2335 = local.member[1u];
let _e2336 = (_e2332 + _e2335);
let _e2338 = (bitcast<i32>(_e86) - 1i);
let _e2340 = select(_e2338, _e2336, (_e2336 < _e2338));
let _e2345 = global_2.member[bitcast<u32>(select(0i, _e2340, (_e2340 > 0i)))];
let _e2346 = bitcast<f32>(_e2345);
let _e2349 = local.member[2u];
let _e2350 = (_e2332 + _e2349);
let _e2352 = select(_e2338, _e2350, (_e2350 < _e2338));
let _e2357 = global_2.member[bitcast<u32>(select(0i, _e2352, (_e2352 > 0i)))];
let _e2359 = local_1[0u];
let _e2362 = (_e2346 + ((bitcast<f32>(_e2357) - _e2346) * _e2359));
let _e2363 = (_e2320 + _e2319);
let _e2364 = local.member[1u];
let _e2365 = (_e2363 + _e2364);
let _e2367 = select(_e2338, _e2365, (_e2365 < _e2338));
let _e2372 = global_2.member[bitcast<u32>(select(0i, _e2367, (_e2367 > 0i)))];
let _e2373 = bitcast<f32>(_e2372);
let _e2374 = local.member[2u];
let _e2375 = (_e2363 + _e2374);
let _e2377 = select(_e2338, _e2375, (_e2375 < _e2338));
let _e2382 = global_2.member[bitcast<u32>(select(0i, _e2377, (_e2377 > 0i)))];
let _e2384 = local_1[0u];
let _e2389 = local_1[1u];
let _e2392 = (_e2362 + (((_e2373 + ((bitcast<f32>(_e2382) - _e2373) * _e2384)) - _e2362) * _e2389));
let _e2393 = (_e2321 + _e2318);
let _e2394 = local.member[1u];
let _e2395 = (_e2393 + _e2394);
let _e2397 = select(_e2338, _e2395, (_e2395 < _e2338));
let _e2402 = global_2.member[bitcast<u32>(select(0i, _e2397, (_e2397 > 0i)))];
let _e2403 = bitcast<f32>(_e2402);
let _e2404 = local.member[2u];
let _e2405 = (_e2393 + _e2404);
let _e2407 = select(_e2338, _e2405, (_e2405 < _e2338));
let _e2412 = global_2.member[bitcast<u32>(select(0i, _e2407, (_e2407 > 0i)))];
let _e2414 = local_1[0u];
let _e2417 = (_e2403 + ((bitcast<f32>(_e2412) - _e2403) * _e2414));
let _e2418 = (_e2321 + _e2319);
let _e2419 = local.member[1u];
let _e2420 = (_e2418 + _e2419);
let _e2422 = select(_e2338, _e2420, (_e2420 < _e2338));
let _e2427 = global_2.member[bitcast<u32>(select(0i, _e2422, (_e2422 > 0i)))];
let _e2428 = bitcast<f32>(_e2427);
let _e2429 = local.member[2u];
let _e2430 = (_e2418 + _e2429);
let _e2432 = select(_e2338, _e2430, (_e2430 < _e2338));
let _e2437 = global_2.member[bitcast<u32>(select(0i, _e2432, (_e2432 > 0i)))];
let _e2439 = local_1[0u];
let _e2443 = local_1[1u];
let _e2448 = local_1[2u];
let _e2455 = global_1.member.member_6.member_5;
let _e2460 = global_1.member.member_6.member_6;
let _e2461 = (((_e2392 + (((_e2417 + (((_e2428 + ((bitcast<f32>(_e2437) - _e2428) * _e2439)) - _e2417) * _e2443)) - _e2392) * _e2448)) * _e2455) + _e2460);
let _e2463 = select(0f, _e2461, (_e2461 > 0f));
let _e2465 = select(1f, _e2463, (_e2463 < 1f));
let _e2468 = global_1.member.member_1;
if ((_e2468 & 16u) == 0u) {
phi_4672_ = type_5(1f, 1f, 1f);
} else {
let _e2474 = global_1.member.member_14.member;
let _e2485 = ((((_e2474.member.member * _e621) + (_e2474.member.member_1 * _e634)) + (_e2474.member.member_2 * _e599)) + _e2474.member_1);
let _e2491 = ((((_e2474.member.member * _e644) + (_e2474.member.member_1 * _e649)) + (_e2474.member.member_2 * _e638)) + _e2474.member_1);
let _e2493 = select(_e2491, _e2485, (_e2485 < _e2491));
let _e2495 = select(_e2491, _e2485, (_e2485 > _e2491));
let _e2497 = (_e2495 - _e2493);
let _e2500 = (-(_e2493) / select(1e-30f, _e2497, (_e2497 > 1e-30f)));
let _e2502 = select(0f, _e2500, (_e2500 > 0f));
let _e2508 = select(select(select(1f, _e2502, (_e2502 < 1f)), 1f, (_e2495 <= 0f)), 0f, (_e2493 > 0f));
let _e2513 = global_1.member.member_14.member_1;
let _e2514 = (_e2513 != 0u);
let _e2524 = global_1.member.member_15.member;
let _e2535 = ((((_e2524.member.member * _e621) + (_e2524.member.member_1 * _e634)) + (_e2524.member.member_2 * _e599)) + _e2524.member_1);
let _e2541 = ((((_e2524.member.member * _e644) + (_e2524.member.member_1 * _e649)) + (_e2524.member.member_2 * _e638)) + _e2524.member_1);
let _e2543 = select(_e2541, _e2535, (_e2535 < _e2541));
let _e2545 = select(_e2541, _e2535, (_e2535 > _e2541));
let _e2547 = (_e2545 - _e2543);
let _e2550 = (-(_e2543) / select(1e-30f, _e2547, (_e2547 > 1e-30f)));
let _e2552 = select(0f, _e2550, (_e2550 > 0f));
let _e2558 = select(select(select(1f, _e2552, (_e2552 < 1f)), 1f, (_e2545 <= 0f)), 0f, (_e2543 > 0f));
let _e2563 = global_1.member.member_15.member_1;
let _e2564 = (_e2563 != 0u);
let _e2574 = global_1.member.member_16.member;
let _e2585 = ((((_e2574.member.member * _e621) + (_e2574.member.member_1 * _e634)) + (_e2574.member.member_2 * _e599)) + _e2574.member_1);
let _e2591 = ((((_e2574.member.member * _e644) + (_e2574.member.member_1 * _e649)) + (_e2574.member.member_2 * _e638)) + _e2574.member_1);
let _e2593 = select(_e2591, _e2585, (_e2585 < _e2591));
let _e2595 = select(_e2591, _e2585, (_e2585 > _e2591));
let _e2597 = (_e2595 - _e2593);
let _e2600 = (-(_e2593) / select(1e-30f, _e2597, (_e2597 > 1e-30f)));
let _e2602 = select(0f, _e2600, (_e2600 > 0f));
let _e2608 = select(select(select(1f, _e2602, (_e2602 < 1f)), 1f, (_e2595 <= 0f)), 0f, (_e2593 > 0f));
let _e2613 = global_1.member.member_16.member_1;
let _e2614 = (_e2613 != 0u);
let _e2624 = global_1.member.member_17.member;
let _e2635 = ((((_e2624.member.member * _e621) + (_e2624.member.member_1 * _e634)) + (_e2624.member.member_2 * _e599)) + _e2624.member_1);
let _e2641 = ((((_e2624.member.member * _e644) + (_e2624.member.member_1 * _e649)) + (_e2624.member.member_2 * _e638)) + _e2624.member_1);
let _e2643 = select(_e2641, _e2635, (_e2635 < _e2641));
let _e2645 = select(_e2641, _e2635, (_e2635 > _e2641));
let _e2647 = (_e2645 - _e2643);
let _e2650 = (-(_e2643) / select(1e-30f, _e2647, (_e2647 > 1e-30f)));
let _e2652 = select(0f, _e2650, (_e2650 > 0f));
let _e2658 = select(select(select(1f, _e2652, (_e2652 < 1f)), 1f, (_e2645 <= 0f)), 0f, (_e2643 > 0f));
let _e2663 = global_1.member.member_17.member_1;
let _e2664 = (_e2663 != 0u);
phi_4672_ = type_5(((((1f * _e2508) * _e2558) * _e2608) * _e2658), ((((1f * select(1f, _e2508, _e2514)) * select(1f, _e2558, _e2564)) * select(1f, _e2608, _e2614)) * select(1f, _e2658, _e2664)), ((((1f * select(1f, 0f, (_e2514 && (_e2491 > 0f)))) * select(1f, 0f, (_e2564 && (_e2541 > 0f)))) * select(1f, 0f, (_e2614 && (_e2591 > 0f)))) * select(1f, 0f, (_e2664 && (_e2641 > 0f)))));
}
let _e2673 = phi_4672_;
let _e2674 = (_e700 - _e664);
let _e2678 = (bitcast<f32>((bitcast<u32>(_e2674) & 2147483647u)) < 1e-12f);
let _e2680 = (1f / select(_e2674, 1f, _e2678));
let _e2682 = ((-0.5f - _e664) * _e2680);
let _e2684 = ((_e2195 - _e664) * _e2680);
let _e2690 = select(_e2684, _e2682, (_e2682 < _e2684));
let _e2692 = select(0f, _e2690, (_e2690 > 0f));
let _e2695 = select(select(1f, _e2692, (_e2692 < 1f)), select(2f, 0f, ((_e664 >= -0.5f) && (_e664 <= _e2195))), _e2678);
let _e2697 = select(_e2684, _e2682, (_e2682 > _e2684));
let _e2699 = select(0f, _e2697, (_e2697 > 0f));
let _e2702 = select(select(1f, _e2699, (_e2699 < 1f)), 1f, _e2678);
let _e2703 = (_e706 - _e679);
let _e2707 = (bitcast<f32>((bitcast<u32>(_e2703) & 2147483647u)) < 1e-12f);
let _e2709 = (1f / select(_e2703, 1f, _e2707));
let _e2711 = ((-0.5f - _e679) * _e2709);
let _e2713 = ((_e2205 - _e679) * _e2709);
let _e2719 = select(_e2713, _e2711, (_e2711 < _e2713));
let _e2721 = select(0f, _e2719, (_e2719 > 0f));
let _e2724 = select(select(1f, _e2721, (_e2721 < 1f)), select(2f, 0f, ((_e679 >= -0.5f) && (_e679 <= _e2205))), _e2707);
let _e2726 = select(_e2713, _e2711, (_e2711 > _e2713));
let _e2728 = select(0f, _e2726, (_e2726 > 0f));
let _e2731 = select(select(1f, _e2728, (_e2728 < 1f)), 1f, _e2707);
let _e2732 = (_e712 - _e694);
let _e2736 = (bitcast<f32>((bitcast<u32>(_e2732) & 2147483647u)) < 1e-12f);
let _e2738 = (1f / select(_e2732, 1f, _e2736));
let _e2740 = ((-0.5f - _e694) * _e2738);
let _e2742 = ((_e2215 - _e694) * _e2738);
let _e2748 = select(_e2742, _e2740, (_e2740 < _e2742));
let _e2750 = select(0f, _e2748, (_e2748 > 0f));
let _e2753 = select(select(1f, _e2750, (_e2750 < 1f)), select(2f, 0f, ((_e694 >= -0.5f) && (_e694 <= _e2215))), _e2736);
let _e2755 = select(_e2742, _e2740, (_e2740 > _e2742));
let _e2757 = select(0f, _e2755, (_e2755 > 0f));
let _e2760 = select(select(1f, _e2757, (_e2757 < 1f)), 1f, _e2736);
let _e2762 = select(_e2731, _e2702, (_e2702 < _e2731));
let _e2766 = select(_e2724, _e2695, (_e2695 > _e2724));
let _e2769 = (select(_e2760, _e2762, (_e2762 < _e2760)) - select(_e2753, _e2766, (_e2766 > _e2753)));
let _e2772 = (_e644 - _e621);
let _e2773 = (_e649 - _e634);
let _e2774 = (_e638 - _e599);
let _e2779 = (((_e2772 * _e2772) + (_e2773 * _e2773)) + (_e2774 * _e2774));
let _e2787 = global_1.member.member_5.member_3;
let _e2788 = ((sqrt(select(0f, _e2779, (_e2779 > 0f))) * select(0f, _e2769, (_e2769 > 0f))) * _e2787);
if (_e100.member_2 >= 3u) {
let _e2791 = (_e2465 * 255f);
let _e2792 = (_e2189.member * 255f);
let _e2793 = (255f - 1f);
let _e2795 = select(0f, _e2791, (_e2791 > 0f));
let _e2797 = select(_e2793, _e2795, (_e2795 < _e2793));
let _e2804 = select(0i, select(select(i32(_e2797), i32(-2147483648), (_e2797 < -2147483600f)), 2147483647i, (_e2797 > 2147483500f)), (_e2797 == _e2797));
let _e2808 = (_e2804 - select(0i, 1i, (_e2797 < f32(_e2804))));
let _e2810 = select(0f, _e2792, (_e2792 > 0f));
let _e2812 = select(_e2793, _e2810, (_e2810 < _e2793));
let _e2819 = select(0i, select(select(i32(_e2812), i32(-2147483648), (_e2812 < -2147483600f)), 2147483647i, (_e2812 > 2147483500f)), (_e2812 == _e2812));
let _e2823 = (_e2819 - select(0i, 1i, (_e2812 < f32(_e2819))));
let _e2826 = (((_e2808 * 256i) + _e2823) * 4i);
let _e2830 = (_e2792 - f32(_e2823));
let _e2832 = (bitcast<i32>(_e90) - 1i);
let _e2834 = select(_e2832, _e2826, (_e2826 < _e2832));
let _e2840 = global_4.member[bitcast<u32>(select(0i, _e2834, (_e2834 > 0i)))];
let _e2841 = (_e2826 + 4i);
let _e2843 = select(_e2832, _e2841, (_e2841 < _e2832));
let _e2849 = global_4.member[bitcast<u32>(select(0i, _e2843, (_e2843 > 0i)))];
let _e2850 = (_e2826 + 1024i);
let _e2852 = select(_e2832, _e2850, (_e2850 < _e2832));
let _e2858 = global_4.member[bitcast<u32>(select(0i, _e2852, (_e2852 > 0i)))];
let _e2859 = (_e2826 + 1028i);
let _e2861 = select(_e2832, _e2859, (_e2859 < _e2832));
let _e2867 = global_4.member[bitcast<u32>(select(0i, _e2861, (_e2861 > 0i)))];
let _e2872 = (bitcast<f32>(((_e2840 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2880 = (_e2872 + (((bitcast<f32>(((_e2849 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2872) * _e2830));
let _e2885 = (bitcast<f32>(((_e2858 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2896 = (_e2880 + (((_e2885 + (((bitcast<f32>(((_e2867 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2885) * _e2830)) - _e2880) * (_e2791 - f32(_e2808))));
let _e2900 = -((_e2896 * (_e2788 * _e2673.member)));
let _e2902 = select(-87f, _e2900, (_e2900 > -87f));
let _e2904 = select(88f, _e2902, (_e2902 < 88f));
let _e2906 = ((_e2904 * 1.442695f) + 0.5f);
let _e2908 = select(-127f, _e2906, (_e2906 > -127f));
let _e2910 = select(128f, _e2908, (_e2908 < 128f));
let _e2917 = select(0i, select(select(i32(_e2910), i32(-2147483648), (_e2910 < -2147483600f)), 2147483647i, (_e2910 > 2147483500f)), (_e2910 == _e2910));
let _e2921 = (_e2917 - select(0i, 1i, (_e2910 < f32(_e2917))));
let _e2922 = f32(_e2921);
let _e2926 = ((_e2904 - (_e2922 * 0.6933594f)) - (_e2922 * -2.1219444e-4f));
let _e2946 = ((1f + (_e2926 * (1f + (_e2926 * (0.5f + (_e2926 * (0.16666667f + (_e2926 * (0.041666668f + (_e2926 * (0.008333334f + (_e2926 * (0.001388889f + (_e2926 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2921 + 127i)) << bitcast<u32>(23i))));
let _e2947 = (1f - _e2946);
phi_5782_ = type_31(_e2946, _e2947, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e2947 / select(1e-12f, _e2896, (_e2896 > 1e-12f))))));
} else {
let _e2955 = (_e2465 * 255f);
let _e2956 = (_e2189.member * 255f);
let _e2957 = (255f - 1f);
let _e2959 = select(0f, _e2955, (_e2955 > 0f));
let _e2961 = select(_e2957, _e2959, (_e2959 < _e2957));
let _e2968 = select(0i, select(select(i32(_e2961), i32(-2147483648), (_e2961 < -2147483600f)), 2147483647i, (_e2961 > 2147483500f)), (_e2961 == _e2961));
let _e2972 = (_e2968 - select(0i, 1i, (_e2961 < f32(_e2968))));
let _e2974 = select(0f, _e2956, (_e2956 > 0f));
let _e2976 = select(_e2957, _e2974, (_e2974 < _e2957));
let _e2983 = select(0i, select(select(i32(_e2976), i32(-2147483648), (_e2976 < -2147483600f)), 2147483647i, (_e2976 > 2147483500f)), (_e2976 == _e2976));
let _e2987 = (_e2983 - select(0i, 1i, (_e2976 < f32(_e2983))));
let _e2990 = (((_e2972 * 256i) + _e2987) * 4i);
let _e2992 = (_e2955 - f32(_e2972));
let _e2994 = (_e2956 - f32(_e2987));
let _e2996 = (bitcast<i32>(_e90) - 1i);
let _e2998 = select(_e2996, _e2990, (_e2990 < _e2996));
let _e3004 = global_4.member[bitcast<u32>(select(0i, _e2998, (_e2998 > 0i)))];
let _e3005 = (_e2990 + 4i);
let _e3007 = select(_e2996, _e3005, (_e3005 < _e2996));
let _e3013 = global_4.member[bitcast<u32>(select(0i, _e3007, (_e3007 > 0i)))];
let _e3014 = (_e2990 + 1024i);
let _e3016 = select(_e2996, _e3014, (_e3014 < _e2996));
let _e3022 = global_4.member[bitcast<u32>(select(0i, _e3016, (_e3016 > 0i)))];
let _e3023 = (_e2990 + 1028i);
let _e3025 = select(_e2996, _e3023, (_e3023 < _e2996));
let _e3031 = global_4.member[bitcast<u32>(select(0i, _e3025, (_e3025 > 0i)))];
let _e3036 = (bitcast<f32>(((_e3004 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3044 = (_e3036 + (((bitcast<f32>(((_e3013 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3036) * _e2994));
let _e3049 = (bitcast<f32>(((_e3022 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3060 = (_e3044 + (((_e3049 + (((bitcast<f32>(((_e3031 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3049) * _e2994)) - _e3044) * _e2992));
let _e3073 = (bitcast<f32>((((_e3004 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3081 = (_e3073 + (((bitcast<f32>((((_e3013 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3073) * _e2994));
let _e3086 = (bitcast<f32>((((_e3022 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3098 = (_e2990 + 1i);
let _e3100 = select(_e2996, _e3098, (_e3098 < _e2996));
let _e3106 = global_4.member[bitcast<u32>(select(0i, _e3100, (_e3100 > 0i)))];
let _e3107 = (_e2990 + 5i);
let _e3109 = select(_e2996, _e3107, (_e3107 < _e2996));
let _e3115 = global_4.member[bitcast<u32>(select(0i, _e3109, (_e3109 > 0i)))];
let _e3116 = (_e2990 + 1025i);
let _e3118 = select(_e2996, _e3116, (_e3116 < _e2996));
let _e3124 = global_4.member[bitcast<u32>(select(0i, _e3118, (_e3118 > 0i)))];
let _e3125 = (_e2990 + 1029i);
let _e3127 = select(_e2996, _e3125, (_e3125 < _e2996));
let _e3133 = global_4.member[bitcast<u32>(select(0i, _e3127, (_e3127 > 0i)))];
let _e3138 = (bitcast<f32>(((_e3106 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3146 = (_e3138 + (((bitcast<f32>(((_e3115 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3138) * _e2994));
let _e3151 = (bitcast<f32>(((_e3124 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3175 = (bitcast<f32>((((_e3106 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3183 = (_e3175 + (((bitcast<f32>((((_e3115 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3175) * _e2994));
let _e3188 = (bitcast<f32>((((_e3124 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3203 = (_e2788 * _e2673.member_1);
let _e3205 = -(((_e3081 + (((_e3086 + (((bitcast<f32>((((_e3031 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3086) * _e2994)) - _e3081) * _e2992)) * _e3203));
let _e3207 = select(-87f, _e3205, (_e3205 > -87f));
let _e3209 = select(88f, _e3207, (_e3207 < 88f));
let _e3211 = ((_e3209 * 1.442695f) + 0.5f);
let _e3213 = select(-127f, _e3211, (_e3211 > -127f));
let _e3215 = select(128f, _e3213, (_e3213 < 128f));
let _e3222 = select(0i, select(select(i32(_e3215), i32(-2147483648), (_e3215 < -2147483600f)), 2147483647i, (_e3215 > 2147483500f)), (_e3215 == _e3215));
let _e3226 = (_e3222 - select(0i, 1i, (_e3215 < f32(_e3222))));
let _e3227 = f32(_e3226);
let _e3231 = ((_e3209 - (_e3227 * 0.6933594f)) - (_e3227 * -2.1219444e-4f));
let _e3253 = -(((_e3146 + (((_e3151 + (((bitcast<f32>(((_e3133 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3151) * _e2994)) - _e3146) * _e2992)) * _e3203));
let _e3255 = select(-87f, _e3253, (_e3253 > -87f));
let _e3257 = select(88f, _e3255, (_e3255 < 88f));
let _e3259 = ((_e3257 * 1.442695f) + 0.5f);
let _e3261 = select(-127f, _e3259, (_e3259 > -127f));
let _e3263 = select(128f, _e3261, (_e3261 < 128f));
let _e3270 = select(0i, select(select(i32(_e3263), i32(-2147483648), (_e3263 < -2147483600f)), 2147483647i, (_e3263 > 2147483500f)), (_e3263 == _e3263));
let _e3274 = (_e3270 - select(0i, 1i, (_e3263 < f32(_e3270))));
let _e3275 = f32(_e3274);
let _e3279 = ((_e3257 - (_e3275 * 0.6933594f)) - (_e3275 * -2.1219444e-4f));
let _e3301 = -(((_e3183 + (((_e3188 + (((bitcast<f32>((((_e3133 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3188) * _e2994)) - _e3183) * _e2992)) * _e3203));
let _e3303 = select(-87f, _e3301, (_e3301 > -87f));
let _e3305 = select(88f, _e3303, (_e3303 < 88f));
let _e3307 = ((_e3305 * 1.442695f) + 0.5f);
let _e3309 = select(-127f, _e3307, (_e3307 > -127f));
let _e3311 = select(128f, _e3309, (_e3309 < 128f));
let _e3318 = select(0i, select(select(i32(_e3311), i32(-2147483648), (_e3311 < -2147483600f)), 2147483647i, (_e3311 > 2147483500f)), (_e3311 == _e3311));
let _e3322 = (_e3318 - select(0i, 1i, (_e3311 < f32(_e3318))));
let _e3323 = f32(_e3322);
let _e3327 = ((_e3305 - (_e3323 * 0.6933594f)) - (_e3323 * -2.1219444e-4f));
let _e3350 = -((_e3060 * (_e2788 * _e2673.member)));
let _e3352 = select(-87f, _e3350, (_e3350 > -87f));
let _e3354 = select(88f, _e3352, (_e3352 < 88f));
let _e3356 = ((_e3354 * 1.442695f) + 0.5f);
let _e3358 = select(-127f, _e3356, (_e3356 > -127f));
let _e3360 = select(128f, _e3358, (_e3358 < 128f));
let _e3367 = select(0i, select(select(i32(_e3360), i32(-2147483648), (_e3360 < -2147483600f)), 2147483647i, (_e3360 > 2147483500f)), (_e3360 == _e3360));
let _e3371 = (_e3367 - select(0i, 1i, (_e3360 < f32(_e3367))));
let _e3372 = f32(_e3371);
let _e3376 = ((_e3354 - (_e3372 * 0.6933594f)) - (_e3372 * -2.1219444e-4f));
let _e3396 = ((1f + (_e3376 * (1f + (_e3376 * (0.5f + (_e3376 * (0.16666667f + (_e3376 * (0.041666668f + (_e3376 * (0.008333334f + (_e3376 * (0.001388889f + (_e3376 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3371 + 127i)) << bitcast<u32>(23i))));
let _e3397 = (1f - _e3396);
phi_5782_ = type_31(_e3396, _e3397, vec3<f32>(((1f + (_e3231 * (1f + (_e3231 * (0.5f + (_e3231 * (0.16666667f + (_e3231 * (0.041666668f + (_e3231 * (0.008333334f + (_e3231 * (0.001388889f + (_e3231 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3226 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3279 * (1f + (_e3279 * (0.5f + (_e3279 * (0.16666667f + (_e3279 * (0.041666668f + (_e3279 * (0.008333334f + (_e3279 * (0.001388889f + (_e3279 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3274 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3327 * (1f + (_e3327 * (0.5f + (_e3327 * (0.16666667f + (_e3327 * (0.041666668f + (_e3327 * (0.008333334f + (_e3327 * (0.001388889f + (_e3327 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3322 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3397 / select(1e-12f, _e3060, (_e3060 > 1e-12f))))));
}
let _e3405 = phi_5782_;
if _e717 {
let _e3409 = global_1.member.member_5.member_2;
let _e3417 = global_1.member.member_5.member_4;
let _e3420 = (_e2189.member_3.x * _e2673.member_2);
let _e3422 = (_e2189.member_3.y * _e2673.member_2);
let _e3424 = (_e2189.member_3.z * _e2673.member_2);
let _e3425 = (0.5f * (_e3409 / select(1e-6f, _e180, (_e180 > 1e-6f))));
let _e3429 = (_e158 + (_e3420 * _e3425));
let _e3430 = (_e169 + (_e3422 * _e3425));
let _e3431 = (_e180 + (_e3424 * _e3425));
let _e3433 = (2f * _e3409);
let _e3435 = ((_e3431 * _e3431) + (_e3433 * _e3424));
let _e3439 = (_e3431 + sqrt(select(0f, _e3435, (_e3435 > 0f))));
let _e3443 = (0.5f * (_e3433 / select(1e-6f, _e3439, (_e3439 > 1e-6f))));
let _e3447 = (_e3429 + (_e3420 * _e3443));
let _e3448 = (_e3430 + (_e3422 * _e3443));
let _e3449 = (_e3431 + (_e3424 * _e3443));
let _e3453 = (_e3417 * _e3417);
let _e3455 = (_e3449 * _e3449);
let _e3463 = (((_e3431 <= 0f) || (_e3435 <= 0f)) || ((_e3449 <= 0f) || (_e3455 <= (_e3453 * (((_e3447 * _e3447) + (_e3448 * _e3448)) + _e3455)))));
let _e3477 = (_e158 + ((_e2189.member_4.x * _e2673.member_2) * _e3409));
let _e3478 = (_e169 + ((_e2189.member_4.y * _e2673.member_2) * _e3409));
let _e3479 = (_e180 + ((_e2189.member_4.z * _e2673.member_2) * _e3409));
let _e3481 = (_e3479 * _e3479);
let _e3490 = ((_e2468 & 1u) != 0u);
let _e3494 = select(_e3463, ((_e3479 <= 0f) || (_e3481 <= (_e3453 * (((_e3477 * _e3477) + (_e3478 * _e3478)) + _e3481)))), _e3490);
phi_5934_ = vec3<f32>(select(select(select(_e3447, _e3429, _e3463), _e3477, _e3490), _e158, _e3494), select(select(select(_e3448, _e3430, _e3463), _e3478, _e3490), _e169, _e3494), select(select(select(_e3449, _e3431, _e3463), _e3479, _e3490), _e180, _e3494));
phi_5935_ = select(1f, 0f, _e3494);
} else {
phi_5934_ = vec3<f32>(_e158, _e169, _e180);
phi_5935_ = 1f;
}
let _e3501 = phi_5934_;
let _e3503 = phi_5935_;
let _e3506 = (_e3405.member * _e3503);
global_5.member[_e115] = (_e126 * (_e3405.member_2.x * _e3506));
global_5.member[_e127] = (_e136 * (_e3405.member_2.y * _e3506));
global_5.member[_e138] = (_e147 * (_e3405.member_2.z * _e3506));
global_5.member[_e149] = _e3501.x;
global_5.member[_e160] = _e3501.y;
global_5.member[_e171] = _e3501.z;
global_5.member[_e182] = _e191;
global_5.member[_e193] = _e202;
global_5.member[_e204] = _e213;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
