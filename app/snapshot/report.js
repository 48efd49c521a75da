for(const box of document.querySelectorAll('.compare')){
  const top=box.querySelector('.top');
  box.querySelector('input').addEventListener('input',e=>top.style.setProperty('--cut',e.target.value+'%'));
  let timer=0,shown=true;
  const button=box.querySelector('button');
  button.addEventListener('click',()=>{
    if(timer){
      clearInterval(timer);
      timer=0;
      top.classList.remove('all','none');
      button.textContent='Blink';
      return}
    button.textContent='Stop';
    timer=setInterval(()=>{
      shown=!shown;
      top.classList.toggle('all',shown);
      top.classList.toggle('none',!shown)},500)})}
